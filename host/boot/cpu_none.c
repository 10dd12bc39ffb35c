/* SPDX-License-Identifier: MIT */
/* The processor of a build without Unicorn: says what to install. */
#include "boot/cpu.h"

#include <stdio.h>
#include <string.h>

void processor_run(const struct processor_job *job, struct processor_report *report) {
    (void)job;
    memset(report, 0, sizeof *report);
    report->end = PROCESSOR_UNAVAILABLE;
    (void)snprintf(report->reason, sizeof report->reason,
                   "this version has no CPU: it was built without Unicorn; install libunicorn-dev "
                   "(Debian) and build again");
}
