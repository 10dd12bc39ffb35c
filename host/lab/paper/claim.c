/* SPDX-License-Identifier: MIT */
/* A claim of the paper beside what was measured. */
#include "lab/paper/claim.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/complain.h"

const char *paper_verdict_text(enum paper_verdict verdict) {
    static const char *const texts[] = {"not measured", "holds", "holds in part", "does not hold"};
    return texts[verdict];
}

void paper_say(char text[PAPER_TEXT_SIZE], const char *format, ...) {
    size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text + used, PAPER_TEXT_SIZE - used, format, arguments);
    va_end(arguments);
}

const char *paper_yes(bool part) {
    return part ? "yes" : "no";
}

int paper_judge(struct paper_claim *claim, const bool *parts, size_t count) {
    size_t holding = 0;
    for (size_t i = 0; i < count; i++) {
        holding += parts[i];
    }
    claim->verdict = holding == count ? PAPER_HOLDS
                     : holding > 0    ? PAPER_HOLDS_IN_PART
                                      : PAPER_DOES_NOT_HOLD;
    return STATUS_DONE;
}
