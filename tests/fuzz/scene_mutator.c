/* SPDX-License-Identifier: MIT */
/* Changes scene texts so that most stay scenes: by numbers, by words, and by groups as wholes. One
 * change in four is libFuzzer's own, of bytes. */
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "fuzz.h"
#include "splitmix64.h"

/* libFuzzer's names for what it calls and for what it offers. */
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t count, size_t most, unsigned seed);
size_t LLVMFuzzerCustomCrossOver(const uint8_t *first, size_t first_count, const uint8_t *second,
                                 size_t second_count, uint8_t *out, size_t most, unsigned seed);
size_t LLVMFuzzerMutate(uint8_t *bytes, size_t count, size_t most);

/* A piece of a text. */
struct span {
    size_t first, count;
};

static uint64_t state;

static size_t choose(size_t count) {
    return (size_t)(splitmix64(&state) % count);
}

/* Puts a text in the place of a span; returns the new length, or the old one where there is no
 * room. */
static size_t replace(uint8_t *bytes, size_t count, size_t most, struct span span, const void *text,
                      size_t length) {
    if (count - span.count + length > most) {
        return count;
    }
    memmove(bytes + span.first + length, bytes + span.first + span.count,
            count - span.first - span.count);
    memcpy(bytes + span.first, text, length);
    return count - span.count + length;
}

static bool is_word(uint8_t letter) {
    return isalnum(letter) || letter == '_' || letter == '.' || letter == '-' || letter == '+';
}

static bool is_number(const uint8_t *bytes, struct span span) {
    uint8_t first = bytes[span.first];
    return isdigit(first) || ((first == '-' || first == '.') && span.count > 1);
}

/* Finds the first word at or behind a random place that is a number, or that is none. */
static bool find_word(const uint8_t *bytes, size_t count, bool number, struct span *span) {
    size_t i = choose(count);
    while (i > 0 && is_word(bytes[i - 1])) {
        i--;
    }
    while (i < count) {
        size_t end = i;
        while (end < count && is_word(bytes[end])) {
            end++;
        }
        *span = (struct span){i, end - i};
        if (end > i && is_number(bytes, *span) == number) {
            return true;
        }
        i = end + 1;
    }
    return false;
}

/* Finds a random bracket of the kind and all that it holds, its end included. */
static bool find_group(const uint8_t *bytes, size_t count, uint8_t kind, struct span *span) {
    size_t i = choose(count), depth = 0;
    while (i < count && bytes[i] != kind) {
        i++;
    }
    for (size_t end = i; end < count; end++) {
        depth += strchr("{([", bytes[end]) != NULL && bytes[end] != '\0';
        depth -= strchr("})]", bytes[end]) != NULL && bytes[end] != '\0' && depth > 0;
        if (depth == 0) {
            *span = (struct span){i, end + 1 - i};
            return true;
        }
    }
    return false;
}

/* Writes a number of the kind that scenes have, or that they should not. */
static int make_number(char *text, size_t size) {
    static const char *const special[] = {"0",       "1",     "-1",     "0.5",     "2",
                                          "1e-6",    "1e6",   "1e12",   "-1e9",    "0.99999999999",
                                          "-0.0",    "1e-12", "0x10",   "1e308",   "5e-324",
                                          "1.0e-40", "170",   "0.0001", "1000000", "3.9999999"};
    switch (choose(4)) {
    case 0:
        return snprintf(text, size, "%s", special[choose(sizeof special / sizeof special[0])]);
    case 1:
        return snprintf(text, size, "%d", (int)choose(21) - 10);
    case 2:
        return snprintf(text, size, "%.3g", ((double)choose(20001) - 10000) / 1000);
    default:
        return snprintf(text, size, "%.17g", ((double)choose(20001) - 10000) / 1e8);
    }
}

static size_t change_number(uint8_t *bytes, size_t count, size_t most) {
    char text[64];
    struct span span, from;
    if (!find_word(bytes, count, true, &span)) {
        return count;
    }
    /* A number that stands elsewhere too makes faces that touch, centres that agree. */
    if (choose(3) == 0 && find_word(bytes, count, true, &from) && from.count < sizeof text) {
        memcpy(text, bytes + from.first, from.count);
        return replace(bytes, count, most, span, text, from.count);
    }
    return replace(bytes, count, most, span, text, (size_t)make_number(text, sizeof text));
}

/* Puts one of the format's words in the place of another word. */
static size_t change_word(uint8_t *bytes, size_t count, size_t most) {
    static const char *const words[] = {"union",       "intersection",  "difference",
                                        "box",         "ball",          "cylinder",
                                        "cone",        "ellipsoid",     "paraboloid",
                                        "hyperboloid", "quadric",       "half_space",
                                        "polyhedron",  "part",          "min",
                                        "max",         "centre",        "radius",
                                        "radii",       "from",          "to",
                                        "from_radius", "to_radius",     "waist",
                                        "gap",         "normal",        "offset",
                                        "through",     "scale",         "rotate",
                                        "translate",   "material",      "coefficients",
                                        "planes",      "ior",           "cauchy",
                                        "absorption",  "transmittance", "ambient_is_own",
                                        "pattern",     "specular",      "gloss",
                                        "direction",   "position",      "colour",
                                        "simple",      "wavelength",    "filter",
                                        "attenuation", "true",          "false",
                                        "depth",       "threshold",     "casts_shadow"};
    const char *word = words[choose(sizeof words / sizeof words[0])];
    struct span span;
    if (!find_word(bytes, count, false, &span)) {
        return count;
    }
    return replace(bytes, count, most, span, word, strlen(word));
}

/* A text that is put together. */
struct draft {
    uint8_t bytes[65536];
    size_t count;
};

static void add(struct draft *draft, const void *bytes, size_t count) {
    if (count <= sizeof draft->bytes - draft->count) {
        memcpy(draft->bytes + draft->count, bytes, count);
        draft->count += count;
    }
}

static void add_text(struct draft *draft, const char *text) {
    add(draft, text, strlen(text));
}

/* Takes a group of another text, or of this one, and puts it in the place of a group of its kind,
 * before that, or makes one solid of both; or leaves the group out. */
static size_t change_group(uint8_t *bytes, size_t count, size_t most, const uint8_t *other,
                           size_t other_count) {
    static const char *const operations[] = {"union", "intersection", "difference"};
    static struct draft draft;
    const uint8_t kind = choose(4) > 0 ? '{' : '(';
    struct span span, from;
    if (!find_group(bytes, count, kind, &span) || !find_group(other, other_count, kind, &from)) {
        return count;
    }
    const uint8_t *group = bytes + span.first;
    draft.count = 0;
    switch (choose(5)) {
    case 0: /* one fewer in a list */
        span.count += span.first + span.count < count && group[span.count] == ',';
        break;
    case 1: /* one more */
        add(&draft, other + from.first, from.count);
        add_text(&draft, ", ");
        add(&draft, group, span.count);
        break;
    case 2:
    case 3:
        add_text(&draft, "{ ");
        add_text(&draft, operations[choose(3)]);
        add_text(&draft, " = ( ");
        add(&draft, group, span.count);
        add_text(&draft, ", ");
        add(&draft, other + from.first, from.count);
        add_text(&draft, " ); }");
        break;
    default:
        add(&draft, other + from.first, from.count);
        break;
    }
    return replace(bytes, count, most, span, draft.bytes, draft.count);
}

size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t count, size_t most, unsigned seed) {
    static uint8_t before[65536];
    state = seed;
    if (count == 0 || count > sizeof before) {
        return LLVMFuzzerMutate(bytes, count, most);
    }
    switch (choose(8)) {
    case 0:
    case 1:
    case 2:
        return change_number(bytes, count, most);
    case 3:
        return change_word(bytes, count, most);
    case 4:
    case 5:
        memcpy(before, bytes, count);
        return change_group(bytes, count, most, before, count);
    default:
        return LLVMFuzzerMutate(bytes, count, most);
    }
}

size_t LLVMFuzzerCustomCrossOver(const uint8_t *first, size_t first_count, const uint8_t *second,
                                 size_t second_count, uint8_t *out, size_t most, unsigned seed) {
    state = seed;
    size_t count = first_count < most ? first_count : most;
    memcpy(out, first, count);
    return count == 0 || second_count == 0 ? count
                                           : change_group(out, count, most, second, second_count);
}
