/* SPDX-License-Identifier: MIT */
/* One access of a trace in words. */
#include "trace/words.h"

#include <stdio.h>

const char *trace_register_name(unsigned offset) {
    static const char *const names[BOARD_PORTS / 2] = {
        [BOARD_CONTROL_1 / 2] = "control 1",
        [BOARD_CONTROL_2 / 2] = "control 2",
        [BOARD_X / 2] = "X",
        [BOARD_Y / 2] = "Y",
        [BOARD_RED / 2] = "red",
        [BOARD_GREEN / 2] = "green",
        [BOARD_BLUE / 2] = "blue",
        [BOARD_MODE / 2] = "mode",
    };
    return names[offset / 2 % (BOARD_PORTS / 2)];
}

static int digits(const struct trace_access *access) {
    return access->width == BUS_WORD ? 4 : 2;
}

static const char *mode_words(unsigned mode) {
    switch (mode) {
    case BOARD_MODE_PC:
        return "the PC's screen only";
    case BOARD_MODE_BOTH:
        return "both, superimposed";
    case BOARD_MODE_BOARD:
        return "the board's picture only";
    default:
        return "of unknown effect";
    }
}

/* Describes a write to a register that has a meaning of its own; false: the register has none. */
static bool words_of_write(char *text, const struct board *before, unsigned offset,
                           const struct trace_access *access) {
    unsigned value = access->value;
    unsigned low = value & 0xFF;
    switch (offset) {
    case BOARD_CONTROL_1:
        (void)snprintf(text, TRACE_WORDS_SIZE, "control 1: index %02X", low);
        return true;
    case BOARD_CONTROL_2:
        (void)snprintf(text, TRACE_WORDS_SIZE, "control 2: register %02X = %02X", before->index,
                       low);
        return true;
    case BOARD_X:
    case BOARD_Y:
        (void)snprintf(text, TRACE_WORDS_SIZE,
                       access->width == BUS_WORD ? "%c = %u" : "%c, low = %u",
                       offset == BOARD_X ? 'X' : 'Y', value);
        return true;
    case BOARD_MODE:
        (void)snprintf(text, TRACE_WORDS_SIZE, "mode %02X: %s", low, mode_words(low));
        return true;
    default:
        return false;
    }
}

static void words_of_pixel(char *text, const struct board *before, unsigned offset,
                           const struct trace_access *access) {
    if (offset == BOARD_RED && access->width == BUS_WORD && !access->is_read &&
        before->desc.profile == BOARD_LATER) {
        (void)snprintf(text, TRACE_WORDS_SIZE, "four pixels from (%u, %u) = %02X", before->x & ~3U,
                       before->y, access->value & 0xFFU);
        return;
    }
    (void)snprintf(text, TRACE_WORDS_SIZE, "%s of (%u, %u) %s %0*X", trace_register_name(offset),
                   before->x, before->y, access->is_read ? "is" : "=", digits(access),
                   access->value);
}

const char *trace_words(char text[TRACE_WORDS_SIZE], const struct board *before,
                        const struct trace_access *access) {
    unsigned offset = (uint16_t)(access->port - before->desc.base);
    if (offset >= BOARD_PORTS) {
        (void)snprintf(text, TRACE_WORDS_SIZE, "not the board's");
    } else if ((offset & 1) != 0) {
        (void)snprintf(text, TRACE_WORDS_SIZE, "%s, %s: %0*X %s", trace_register_name(offset),
                       access->width == BUS_WORD ? "across two registers" : "upper half",
                       digits(access), access->value, access->is_read ? "read" : "written");
    } else if (offset >= BOARD_RED && offset <= BOARD_BLUE) {
        words_of_pixel(text, before, offset, access);
    } else if (access->is_read || !words_of_write(text, before, offset, access)) {
        (void)snprintf(text, TRACE_WORDS_SIZE, "%s is %0*X", trace_register_name(offset),
                       digits(access), access->value);
    }
    return text;
}
