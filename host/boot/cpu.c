/* SPDX-License-Identifier: MIT */
/* The processor of this build, if there is one. */
#include "boot/cpu.h"

#include <stdio.h>
#include <string.h>

void processor_run(const struct processor_job *job, struct processor_report *report) {
    memset(report, 0, sizeof *report);
    report->end = PROCESSOR_UNAVAILABLE;
    if (processors_built[0] != NULL) {
        processors_built[0]->run(job, report);
        return;
    }
    (void)snprintf(report->reason, sizeof report->reason,
                   "this version has no CPU: it was built without Unicorn; install libunicorn-dev "
                   "(Debian) and build again");
}
