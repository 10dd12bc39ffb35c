/* SPDX-License-Identifier: MIT */
/* The table's setters for what is asked of the board and of a trace. */
#include "options/board_setters.h"

#include <string.h>

#include "base/numbers.h"

enum { ONE_IN_MOST = 1000000000, BUS_WAIT_MOST = 100000, PART_SIZE = 32 };

static enum value_verdict verdict(bool is_allowed) {
    return is_allowed ? VALUE_TAKEN : VALUE_WRONG;
}

/* Sets the flag of an option without a value. */
static enum value_verdict set_flag(bool *flag) {
    *flag = true;
    return VALUE_TAKEN;
}

enum value_verdict set_ports_are_mine(struct options *options, const char *value) {
    (void)value;
    return set_flag(&options->ports_are_mine);
}

enum value_verdict set_list(struct options *options, const char *value) {
    (void)value;
    return set_flag(&options->tracing.lists);
}

enum value_verdict set_statistics(struct options *options, const char *value) {
    (void)value;
    return set_flag(&options->tracing.counts);
}

enum value_verdict set_violations(struct options *options, const char *value) {
    (void)value;
    return set_flag(&options->tracing.judges);
}

enum value_verdict set_against(struct options *options, const char *value) {
    options->tracing.against = value;
    return verdict(value[0] != '\0');
}

enum value_verdict set_to(struct options *options, const char *value) {
    bool is_text = strcmp(value, "text") == 0;
    options->tracing.converts = true;
    options->tracing.to = is_text ? TRACE_TEXT : TRACE_BINARY;
    return verdict(is_text || strcmp(value, "binary") == 0);
}

enum value_verdict set_picture(struct options *options, const char *value) {
    static const char *const words[] = {"screen", "memory", "whole"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(value, words[i]) == 0) {
            options->board.picture = (enum picture_kind)i;
            return VALUE_TAKEN;
        }
    }
    return VALUE_WRONG;
}

enum value_verdict set_native(struct options *options, const char *value) {
    options->board.native = value;
    return verdict(value[0] != '\0');
}

enum value_verdict set_bus_wait(struct options *options, const char *value) {
    return verdict(value_real(value, 0, BUS_WAIT_MOST, &options->board.bus_wait));
}

enum value_verdict set_frame_seconds(struct options *options, const char *value) {
    return verdict(value_real(value, 1e-6, 1e9, &options->board.frame_seconds));
}

/* ---- Faults --------------------------------------------------------------------------------- */

static bool read_one_in(uint32_t *one_in, const char *value) {
    uint64_t number;
    if (!value_whole(value, 1, ONE_IN_MOST, &number)) {
        return false;
    }
    *one_in = (uint32_t)number;
    return true;
}

static bool read_count(uint64_t *count, uint64_t least, const char *value) {
    uint64_t number;
    if (!value_whole(value, least, UINT32_MAX, &number)) {
        return false;
    }
    *count = number;
    return true;
}

static bool read_dead_port(struct fault_plan *plan, const char *value) {
    uint64_t port;
    if (!value_port(value, &port)) {
        return false;
    }
    plan->has_dead_port = true;
    plan->dead_port = (uint16_t)port;
    return true;
}

/* Reads one fault of the list: a word, or a name and its value. Returns false where it is
 * invalid. */
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

static bool read_faults(struct board_options *options, const char *value) {
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
            return true;
        }
        value += length + 1;
    }
}

enum value_verdict set_faults(struct options *options, const char *value) {
    return verdict(read_faults(&options->board, value));
}

enum value_verdict set_stop(struct options *options, const char *value) {
    return verdict(read_count(&options->board.stop, 1, value));
}
