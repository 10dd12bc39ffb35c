/* SPDX-License-Identifier: MIT */
/* Values that no type of the tables can read. */
#include <string.h>

#include "base/numbers.h"
#include "options/options_internal.h"
#include "render/arithmetic.h"

enum { ONE_IN_MOST = 1000000000, PART_SIZE = 32 };

/* Finds the place of a value among words; -1: it is none of them. */
static int find_word(const char *value, const char *const *words) {
    for (int i = 0; words[i] != NULL; i++) {
        if (strcmp(value, words[i]) == 0) {
            return i;
        }
    }
    return -1;
}

enum value_verdict set_arithmetic(struct options *options, const char *value) {
    options->arithmetic = value;
    return arithmetic_is_missing(value) ? VALUE_NOT_BUILT
                                        : option_verdict(arithmetic_find(value) != NULL);
}

enum value_verdict set_size(struct options *options, const char *value) {
    uint64_t width, height;
    if (!value_pair(value, 'x', 1, BOARD_WIDTH, BOARD_HEIGHT, &width, &height)) {
        return VALUE_WRONG;
    }
    options->overrides.width = (int)width;
    options->overrides.height = (int)height;
    return VALUE_TAKEN;
}

const char *const scene_model_words[] = {"simple", "fresnel", "wavelength", "absorption", NULL};

/* Sets the model. Absorption is a property of materials and goes with every model: the word alone
 * stands for the standard model. */
enum value_verdict set_model(struct options *options, const char *value) {
    static const enum scene_model models[] = {MODEL_SIMPLE, MODEL_FRESNEL, MODEL_WAVELENGTH,
                                              MODEL_FRESNEL};
    int word = find_word(value, scene_model_words);
    options->overrides.model = models[word >= 0 ? word : 1];
    return option_verdict(word >= 0);
}

enum value_verdict set_colour(struct options *options, const char *value) {
    static const char *const words[] = {"full", "dither", "exposures", NULL};
    static const enum scene_colour colours[] = {COLOUR_FULL, COLOUR_DITHER, COLOUR_EXPOSURES};
    static const char bits[] = "bits:";
    uint64_t kept;
    int word = find_word(value, words);
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
    return option_verdict(read_faults(&options->board, value));
}

enum value_verdict set_value(struct options *options, const char *value) {
    struct scene_overrides *overrides = &options->overrides;
    if (strchr(value, '=') == NULL || overrides->set_count == SCENE_SETS_MOST) {
        return VALUE_WRONG;
    }
    overrides->sets[overrides->set_count++] = value;
    return VALUE_TAKEN;
}
