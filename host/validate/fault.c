/* SPDX-License-Identifier: MIT */
/* The validator's faults: the first is kept in words, with its place and line. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "validate/validate_internal.h"

void validate_fault(struct validator *validator, const double place[3], const char *format, ...) {
    struct validation *validation = validator->validation;
    if (validation->faults++ > 0) {
        return;
    }
    va_list arguments;
    va_start(arguments, format);
    int used = vsnprintf(validation->first, sizeof validation->first, format, arguments);
    va_end(arguments);
    if (place != NULL && used >= 0 && (size_t)used < sizeof validation->first) {
        double file[3];
        for (int i = 0; i < 3; i++) {
            file[i] = ldexp(place[i], -validator->scene->exponent) + validator->scene->centre[i];
        }
        (void)snprintf(validation->first + used, sizeof validation->first - (size_t)used,
                       ", at (%.12g, %.12g, %.12g)", file[0], file[1], file[2]);
    }
}

unsigned validate_line(const struct validator *validator, uint32_t primitive) {
    return primitive < validator->scene->primitive_count
               ? validator->scene->primitives[primitive].line
               : 0;
}
