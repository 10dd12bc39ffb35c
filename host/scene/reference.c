/* SPDX-License-Identifier: MIT */
/* The keys of a scene file in words, from the rows that the file is read by. */
#include "scene/reference.h"

#include <math.h>

#include "scene/keys.h"

/* Prints a range, unless a noun says as much as the range's name. */
static void print_range(FILE *out, const struct scene_range *range, bool has_noun) {
    if (range->name != NULL) {
        (void)fprintf(out, "%s", has_noun ? "" : range->name);
    } else {
        (void)fprintf(out, "%s%.10g..%.10g", has_noun ? ", " : "", range->least, range->most);
    }
}

/* Prints what may stand under a key. */
static void print_type(FILE *out, const struct scene_key *row) {
    const bool has_noun = row->noun != NULL;
    (void)fprintf(out, "%s", has_noun ? row->noun : "");
    switch (row->type) {
    case KEY_NUMBER:
        print_range(out, row->range, has_noun);
        break;
    case KEY_NUMBERS:
        if (!has_noun) {
            (void)fprintf(out, "%d numbers", row->count);
        }
        print_range(out, row->range, true);
        break;
    case KEY_THREE:
        print_range(out, row->range, has_noun);
        (void)fprintf(out, ", or 3 of them");
        break;
    case KEY_WHOLE:
        (void)fprintf(out, "whole number");
        if (row->range->least < row->range->most) {
            print_range(out, row->range, true);
        } else {
            (void)fprintf(out, ", %.10g", row->range->least);
        }
        break;
    case KEY_TRUTH:
        (void)fprintf(out, "truth");
        break;
    case KEY_TEXT:
        (void)fprintf(out, "%s", has_noun ? "" : "string");
        break;
    case KEY_WORD:
        for (int i = 0; !has_noun && row->words[i] != NULL; i++) {
            (void)fprintf(out, "%s`\"%s\"`", i > 0 ? ", " : "", row->words[i]);
        }
        break;
    case KEY_GROUP:
        (void)fprintf(out, "%s", has_noun ? "" : "group");
        break;
    case KEY_LIST:
        if (!has_noun) {
            (void)fprintf(out, "list of solids, %.0f or more", row->range->least);
        } else if (row->range->most < INFINITY) {
            (void)fprintf(out, ", %.0f to %.0f", row->range->least, row->range->most);
        }
        break;
    case KEY_OTHER:
        break;
    }
}

static void print_numbers(FILE *out, const double *numbers, int count) {
    (void)fprintf(out, "`[");
    for (int i = 0; i < count; i++) {
        (void)fprintf(out, "%s%.10g", i > 0 ? ", " : "", numbers[i]);
    }
    (void)fprintf(out, "]`");
}

/* Prints what a missing key means. `defaults` is NULL where all is zero. */
static void print_default(FILE *out, const struct scene_key *row, const void *defaults) {
    static const double zeros[17];
    const void *at =
        defaults == NULL ? (const void *)zeros : (const unsigned char *)defaults + row->offset;
    if (row->is_required || row->fallback != NULL) {
        (void)fprintf(out, "%s", row->is_required ? "required" : row->fallback);
        return;
    }
    switch (row->type) {
    case KEY_NUMBER:
    case KEY_THREE:
        (void)fprintf(out, "%.10g", *(const double *)at);
        break;
    case KEY_NUMBERS:
        print_numbers(out, at, row->count);
        break;
    case KEY_WHOLE:
        (void)fprintf(out, "%d", *(const int *)at);
        break;
    case KEY_TRUTH:
        (void)fprintf(out, "`%s`", *(const bool *)at ? "true" : "false");
        break;
    case KEY_TEXT:
        (void)fprintf(out, "`\"\"`");
        break;
    case KEY_WORD:
        (void)fprintf(out, "`\"%s\"`", row->words[*(const int *)at]);
        break;
    case KEY_GROUP:
    case KEY_LIST:
    case KEY_OTHER:
        break;
    }
}

static void print_rows(FILE *out, const char *title, const struct scene_keys *keys, size_t first,
                       size_t end) {
    (void)fprintf(out, "## %s\n\n| key | type, range | default | meaning |\n|---|---|---|---|\n",
                  title);
    for (size_t i = first; i < end; i++) {
        const struct scene_key *row = &keys->rows[i];
        (void)fprintf(out, "| `%s` | ", row->name);
        print_type(out, row);
        (void)fprintf(out, " | ");
        print_default(out, row, keys->defaults);
        (void)fprintf(out, " | %s |\n", row->meaning != NULL ? row->meaning : "");
    }
    (void)fprintf(out, "\n");
}

/* Prints the kinds of solids, each with its own keys. */
static void print_kinds(FILE *out) {
    (void)fprintf(out, "## kinds of solids\n\n| kind | its keys | what it is |\n|---|---|---|\n");
    for (size_t i = 0; i < SCENE_KINDS; i++) {
        const struct scene_key *kind = &scene_solid_keys.rows[i];
        (void)fprintf(out, "| `%s` | ", kind->name);
        if (i >= scene_leaf_count) {
            print_type(out, kind);
        }
        for (size_t j = 0; i < scene_leaf_count && j < scene_leaves[i].keys.count; j++) {
            const struct scene_key *row = &scene_leaves[i].keys.rows[j];
            (void)fprintf(out, "%s`%s` (", j > 0 ? ", " : "", row->name);
            print_type(out, row);
            if (!row->is_required) {
                (void)fprintf(out, "; default: ");
                print_default(out, row, NULL);
            }
            (void)fprintf(out, ")");
        }
        (void)fprintf(out, " | %s |\n", kind->meaning);
    }
    (void)fprintf(out, "\n");
}

void scene_print_reference(FILE *out) {
    static const struct {
        const char *title;
        const struct scene_keys *keys;
        size_t first, end; /* end 0: all */
    } groups[] = {{"scene", &scene_top_keys, 0, 0},
                  {"attenuation", &scene_attenuation_keys, 0, 0},
                  {"camera", &scene_camera_keys, 0, 0},
                  {"light", &scene_light_keys, 0, 0},
                  {"material", &scene_material_keys, 0, SCENE_TRANSPARENT_ROW},
                  {"transparent material", &scene_material_keys, SCENE_TRANSPARENT_ROW, 0},
                  {"pattern", &scene_pattern_keys, 0, 0},
                  {"solid", &scene_solid_keys, SCENE_KINDS, 0},
                  {"plane", &scene_plane_keys, 0, 0},
                  {"part", &scene_part_keys, 0, 0},
                  {"object", &scene_object_keys, 0, 0}};
    for (size_t i = 0; i < sizeof groups / sizeof *groups; i++) {
        const struct scene_keys *keys = groups[i].keys;
        print_rows(out, groups[i].title, keys, groups[i].first,
                   groups[i].end > 0 ? groups[i].end : keys->count);
    }
    print_kinds(out);
}
