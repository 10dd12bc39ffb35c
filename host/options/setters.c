/* SPDX-License-Identifier: MIT */
/* Values that no type of the tables can read. */
#include <string.h>

#include "base/numbers.h"
#include "options/options_internal.h"
#include "render/arithmetic.h"

enum { ONE_IN_MOST = 1000000000, PART_SIZE = 32 };

enum value_verdict set_arithmetic(struct options *options, const char *value) {
    options->arithmetic = value;
    return arithmetic_is_missing(value) ? VALUE_NOT_BUILT
                                        : option_verdict(arithmetic_find(value) != NULL);
}

static enum value_verdict take_size(struct options *options, const char *value, uint64_t dots) {
    uint64_t width, height;
    if (!value_pair(value, 'x', 1, BOARD_WIDTH / dots, BOARD_HEIGHT / dots, &width, &height)) {
        return VALUE_WRONG;
    }
    options->overrides.width = (int)width;
    options->overrides.height = (int)height;
    return VALUE_TAKEN;
}

enum value_verdict set_size(struct options *options, const char *value) {
    return take_size(options, value, 1);
}

enum value_verdict set_small_size(struct options *options, const char *value) {
    return take_size(options, value, 2);
}

const char *const scene_model_words[] = {"simple", "fresnel", "wavelength", "absorption", NULL};

/* Sets the model. Absorption is a property of materials and goes with every model: the word alone
 * stands for the standard model. */
enum value_verdict set_model(struct options *options, const char *value) {
    static const enum scene_model models[] = {MODEL_SIMPLE, MODEL_FRESNEL, MODEL_WAVELENGTH,
                                              MODEL_FRESNEL};
    int word = option_word(value, scene_model_words);
    options->overrides.model = models[word >= 0 ? word : 1];
    return option_verdict(word >= 0);
}

enum value_verdict set_colour(struct options *options, const char *value) {
    static const char *const words[] = {"full", "dither", "exposures", NULL};
    static const enum scene_colour colours[] = {COLOUR_FULL, COLOUR_DITHER, COLOUR_EXPOSURES};
    static const char bits[] = "bits:";
    uint64_t kept;
    int word = option_word(value, words);
    if (strncmp(value, bits, sizeof bits - 1) == 0) {
        options->overrides.colour = COLOUR_BITS;
        if (!value_whole(value + sizeof bits - 1, 1, 8, &kept)) {
            return VALUE_WRONG;
        }
        options->overrides.colour_bits = (int)kept;
        return VALUE_TAKEN;
    }
    options->overrides.colour = colours[word >= 0 ? word : 0];
    return option_verdict(word >= 0);
}

enum value_verdict set_base(struct options *options, const char *value) {
    uint64_t base;
    if (!value_port(value, &base) || !board_base_is_offered((uint16_t)base)) {
        return VALUE_WRONG;
    }
    options->board.base = (uint16_t)base;
    return VALUE_TAKEN;
}

enum value_verdict set_strict(struct options *options, const char *value) {
    options->board.strict = true;
    options->board.has_strict_grade = value != NULL;
    return option_verdict(value == NULL ||
                          board_grade_from_text(value, &options->board.strict_grade));
}

/* ---- Faults --------------------------------------------------------------------------------- */

static enum value_verdict set_dead_port(struct options *options, const char *value) {
    uint64_t port;
    bool is_port = value_port(value, &port);
    options->board.faults.has_dead_port = is_port;
    options->board.faults.dead_port = is_port ? (uint16_t)port : 0;
    return option_verdict(is_port);
}

static enum value_verdict set_lost(struct options *options, const char *value) {
    (void)value;
    options->board.faults.vanish_status = BUS_LOST;
    return VALUE_TAKEN;
}

#define NUMBER(member, from, to)                                                                   \
    .value = "N", WHOLE_IN(struct options, board.faults.member, from, to)

/* Lists what --faults is made of, in rows like those of options. */
static const struct option_entry fault_entries[] = {
    {.name = "seed", NUMBER(seed, 0, UINT32_MAX)},
    {.name = "lose", NUMBER(lose_one_in, 1, ONE_IN_MOST)},
    {.name = "flip", NUMBER(flip_write_one_in, 1, ONE_IN_MOST)},
    {.name = "flip-read", NUMBER(flip_read_one_in, 1, ONE_IN_MOST)},
    {.name = "vanish", NUMBER(vanish_after, 1, UINT32_MAX)},
    {.name = "dead", .value = "PORT", .type = OPTION_OWN, .set = set_dead_port},
    {.name = "absent", FLAG_IN(struct options, board.faults.is_absent)},
    {.name = "lost", .type = OPTION_OWN, .set = set_lost},
    {.name = NULL}};

/* Reads one fault of the list: a word, or a name and its value. */
static enum value_verdict read_fault(struct options *options, char *part) {
    const struct option_entry *entry = fault_entries;
    char *value = strchr(part, '=');
    if (value != NULL) {
        *value++ = '\0';
    }
    while (entry->name != NULL && strcmp(entry->name, part) != 0) {
        entry++;
    }
    return entry->name == NULL || (value == NULL) != (entry->value == NULL)
               ? VALUE_WRONG
               : option_take(entry, value, options);
}

enum value_verdict set_faults(struct options *options, const char *value) {
    options->board.has_faults = true;
    for (;;) {
        char part[PART_SIZE];
        size_t length = strcspn(value, ",");
        (void)snprintf(part, sizeof part, "%.*s", (int)length, value);
        if (length >= sizeof part || read_fault(options, part) != VALUE_TAKEN) {
            return VALUE_WRONG;
        }
        if (value[length] == '\0') {
            return VALUE_TAKEN;
        }
        value += length + 1;
    }
}

enum value_verdict set_value(struct options *options, const char *value) {
    struct scene_overrides *overrides = &options->overrides;
    if (strchr(value, '=') == NULL || overrides->set_count == SCENE_SETS_MOST) {
        return VALUE_WRONG;
    }
    overrides->sets[overrides->set_count++] = value;
    return VALUE_TAKEN;
}
