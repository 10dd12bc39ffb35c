/* SPDX-License-Identifier: MIT */
/* Options about the board behind the ports. */
#include "board_options.h"

#include <string.h>

#include "values.h"

enum { ONE_IN_MOST = 1000000000, BUS_WAIT_MOST = 100000, PART_SIZE = 32 };

bool read_picture_kind(struct board_options *options, const char *value) {
    static const char *const words[] = {"screen", "memory", "whole"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(value, words[i]) == 0) {
            options->picture = (enum picture_kind)i;
            return true;
        }
    }
    return false;
}

bool read_native(struct board_options *options, const char *value) {
    options->native = value;
    return value[0] != '\0';
}

bool read_stop(struct board_options *options, const char *value) {
    unsigned long stop;
    if (!value_whole(value, 1, 0xFFFFFFFFul, &stop)) {
        return false;
    }
    options->stop = stop;
    return true;
}

bool read_bus_wait(struct board_options *options, const char *value) {
    return value_real(value, 0, BUS_WAIT_MOST, &options->bus_wait);
}

bool read_frame_seconds(struct board_options *options, const char *value) {
    return value_real(value, 1e-6, 1e9, &options->frame_seconds);
}

/* ---- Faults --------------------------------------------------------------------------------- */

static bool read_one_in(uint32_t *one_in, const char *value) {
    unsigned long number;
    if (!value_whole(value, 1, ONE_IN_MOST, &number)) {
        return false;
    }
    *one_in = (uint32_t)number;
    return true;
}

static bool read_count(uint64_t *count, unsigned long least, const char *value) {
    unsigned long number;
    if (!value_whole(value, least, 0xFFFFFFFFul, &number)) {
        return false;
    }
    *count = number;
    return true;
}

static bool read_dead_port(struct fault_plan *plan, const char *value) {
    unsigned long port;
    if (!value_port(value, &port)) {
        return false;
    }
    plan->has_dead_port = true;
    plan->dead_port = (uint16_t)port;
    return true;
}

/* One fault of the list: a word, or a name and its value. */
static bool read_fault(struct fault_plan *plan, char *part) {
    char *value = strchr(part, '=');
    if (value == NULL) {
        plan->is_absent = plan->is_absent || strcmp(part, "absent") == 0;
        if (strcmp(part, "lost") == 0) {
            plan->vanish_status = BUS_LOST;
        }
        return strcmp(part, "absent") == 0 || strcmp(part, "lost") == 0;
    }
    *value++ = '\0';
    if (strcmp(part, "seed") == 0) {
        return read_count(&plan->seed, 0, value);
    }
    if (strcmp(part, "lose") == 0) {
        return read_one_in(&plan->lose_one_in, value);
    }
    if (strcmp(part, "flip") == 0) {
        return read_one_in(&plan->flip_write_one_in, value);
    }
    if (strcmp(part, "flip-read") == 0) {
        return read_one_in(&plan->flip_read_one_in, value);
    }
    if (strcmp(part, "vanish") == 0) {
        return read_count(&plan->vanish_after, 1, value);
    }
    return strcmp(part, "dead") == 0 && read_dead_port(plan, value);
}

bool read_faults(struct board_options *options, const char *value) {
    options->has_faults = true;
    for (;;) {
        char part[PART_SIZE];
        size_t length = strcspn(value, ",");
        if (length >= sizeof part) {
            return false;
        }
        memcpy(part, value, length);
        part[length] = '\0';
        if (!read_fault(&options->faults, part)) {
            return false;
        }
        if (value[length] == '\0') {
            /* "lost" says how a board vanishes, and so needs to know when. */
            return options->faults.vanish_status == BUS_OK || options->faults.vanish_after != 0;
        }
        value += length + 1;
    }
}
