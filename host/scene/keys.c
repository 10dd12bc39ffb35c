/* SPDX-License-Identifier: MIT */
/* Reads the members of a group by rows; every refusal names the key and what is allowed. */
#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/nearest.h"
#include "scene/hints.h"

const struct scene_range RANGE_LENGTH = {1e-9, 1e9, "length"};
const struct scene_range RANGE_COORDINATE = {-1e9, 1e9, "coordinate"};
const struct scene_range RANGE_SHARE = {0, 1, NULL};
const struct scene_range RANGE_COLOUR = {0, 255, NULL};

enum { NAMES_MOST = 400, WORDS_MOST = 63 };

static const char *type_name(const struct scene_value *value) {
    switch (value->kind) {
    case VALUE_GROUP:
        return "a group { }";
    case VALUE_ARRAY:
        return "an array [ ]";
    case VALUE_LIST:
        return "a list ( )";
    case VALUE_STRING:
        return "a string";
    case VALUE_BOOLEAN:
        return "true or false";
    case VALUE_NUMBER:
    case VALUE_REFUSED:
        break;
    }
    return "a number";
}

/* Refuses the type of a value, unless the value was refused already. */
static bool fail_type(const struct scene_scope *scope, const char *key,
                      const struct scene_value *value, const char *wanted) {
    return value->kind != VALUE_REFUSED &&
           scene_fail(scope->reader, value->at, "'%s' of the %s has to be %s, and is %s", key,
                      scope->what, wanted, type_name(value));
}

/* Returns the number that a value is: a plain one, or one in parentheses; NULL: the value is no
 * number. */
static const struct scene_value *number_in(const struct scene_value *value) {
    while (value->kind == VALUE_LIST && value->count == 1) {
        value = value->members;
    }
    return value->kind == VALUE_NUMBER ? value : NULL;
}

/* Takes a number that is in range. The comparison is written so that not-a-number fails it. */
static bool take_number(const struct scene_scope *scope, const char *key, struct scene_place at,
                        const struct scene_range *range, double value, double *number) {
    if (value >= range->least && value <= range->most) {
        *number = value + 0.0; /* no negative zero */
        return true;
    }
    return scene_fail(scope->reader, at, "'%s' of the %s is %.15g: %.10g to %.10g is allowed", key,
                      scope->what, value, range->least, range->most);
}

bool scene_read_number(const struct scene_scope *scope, const char *key,
                       const struct scene_value *value, const struct scene_range *range,
                       double *number) {
    const struct scene_value *found = number_in(value);
    return found == NULL ? fail_type(scope, key, value, "a number")
                         : take_number(scope, key, value->at, range, found->number, number);
}

bool scene_read_numbers(const struct scene_scope *scope, const char *key,
                        const struct scene_value *value, const struct scene_range *range, int count,
                        double *numbers) {
    bool is_good = !value->is_partial;
    if (!value_is_sequence(value)) {
        char wanted[40];
        (void)snprintf(wanted, sizeof wanted, "%d numbers in [ ] or ( )", count);
        return fail_type(scope, key, value, wanted);
    }
    if (is_good && value->count != (size_t)count) {
        return scene_fail(
            scope->reader, value->at, "'%s' of the %s has to be %d numbers, and is %zu%s", key,
            scope->what, count, value->count,
            value->count > (size_t)count ? " (the decimal point is a dot, not a comma)" : "");
    }
    for (size_t i = 0; i < value->count && i < (size_t)count; i++) {
        const struct scene_value *element = &value->members[i], *found = number_in(element);
        if (found != NULL) {
            is_good =
                take_number(scope, key, element->at, range, found->number, &numbers[i]) && is_good;
        } else if (element->kind != VALUE_REFUSED) {
            is_good = scene_fail(scope->reader, element->at,
                                 "'%s' of the %s has to be %d numbers, and one is %s", key,
                                 scope->what, count, type_name(element));
        } else {
            is_good = false;
        }
    }
    return is_good;
}

static bool read_three(const struct scene_scope *scope, const struct scene_key *row,
                       const struct scene_value *value, double *numbers) {
    if (number_in(value) != NULL) {
        bool is_good = scene_read_number(scope, row->name, value, row->range, numbers);
        numbers[2] = numbers[1] = numbers[0];
        return is_good;
    }
    if (!value_is_sequence(value)) {
        return fail_type(scope, row->name, value, "a number, or 3 numbers in [ ] or ( )");
    }
    return scene_read_numbers(scope, row->name, value, row->range, 3, numbers);
}

static bool read_whole(const struct scene_scope *scope, const struct scene_key *row,
                       const struct scene_value *value, int *whole) {
    double number = 0;
    if (!scene_read_number(scope, row->name, value, row->range, &number)) {
        return false;
    }
    if (floor(number) != number) {
        return scene_fail(scope->reader, value->at,
                          "'%s' of the %s is %.10g: a whole number, %.10g to %.10g, is allowed",
                          row->name, scope->what, number, row->range->least, row->range->most);
    }
    *whole = (int)number;
    return true;
}

/* Reads one of the words of a row, as its index. */
static bool read_word(const struct scene_scope *scope, const struct scene_key *row,
                      const struct scene_value *value, int *index) {
    char list[NAMES_MOST] = "";
    size_t used = 0;
    if (value->kind != VALUE_STRING) {
        return fail_type(scope, row->name, value, "a string in quotes");
    }
    for (int i = 0; row->words[i] != NULL && used < sizeof list; i++) {
        if (strcmp(row->words[i], value->text) == 0) {
            *index = i;
            return true;
        }
        used += (size_t)snprintf(list + used, sizeof list - used, "%s\"%s\"", i ? ", " : "",
                                 row->words[i]);
    }
    return scene_fail(scope->reader, value->at, "'%s' of the %s is \"%.40s\": %s are allowed",
                      row->name, scope->what, value->text, list);
}

static bool check_list(const struct scene_scope *scope, const struct scene_key *row,
                       const struct scene_value *value) {
    if (!value_is_sequence(value)) {
        return fail_type(scope, row->name, value, "a list ( )");
    }
    const double length = (double)value->count;
    if (value->is_partial || (length >= row->range->least && length <= row->range->most)) {
        return true;
    }
    return row->range->most < INFINITY
               ? scene_fail(scope->reader, value->at,
                            "'%s' of the %s has %.0f elements: %.0f to %.0f are allowed", row->name,
                            scope->what, length, row->range->least, row->range->most)
               : scene_fail(scope->reader, value->at,
                            "'%s' of the %s has %.0f elements: at least %.0f must be there",
                            row->name, scope->what, length, row->range->least);
}

/* Reads what stands under a key into its place. */
static bool read_row(const struct scene_scope *scope, const struct scene_key *row,
                     const struct scene_value *value, void *place) {
    const size_t before = scope->reader->refusal_count;
    switch (row->type) {
    case KEY_NUMBER:
        return scene_read_number(scope, row->name, value, row->range, place);
    case KEY_NUMBERS:
        return scene_read_numbers(scope, row->name, value, row->range, row->count, place);
    case KEY_THREE:
        return read_three(scope, row, value, place);
    case KEY_WHOLE:
        return read_whole(scope, row, value, place);
    case KEY_WORD:
        return read_word(scope, row, value, place);
    case KEY_LIST:
        return check_list(scope, row, value);
    case KEY_TRUTH:
        if (value->kind == VALUE_BOOLEAN) {
            *(bool *)place = value->truth;
        }
        return value->kind == VALUE_BOOLEAN || fail_type(scope, row->name, value, "true or false");
    case KEY_TEXT:
        if (value->text != NULL) {
            *(const char **)place = value->text;
        }
        return value->kind == VALUE_STRING ||
               fail_type(scope, row->name, value, "a string in quotes");
    case KEY_GROUP:
        return value->kind == VALUE_GROUP || fail_type(scope, row->name, value, "a group { }");
    case KEY_OTHER:
        row->read(scope, value, place);
        break;
    }
    return scope->reader->refusal_count == before && value->kind != VALUE_REFUSED;
}

/* Refuses a key without a row, with the nearest key or a hint. */
static bool refuse_key(const struct scene_scope *scope, const struct scene_keys *keys,
                       const struct scene_value *member) {
    const char *names[WORDS_MOST + 1] = {NULL}, *name = member->name;
    char list[NAMES_MOST] = "";
    size_t used = 0;
    for (size_t i = 0; i < keys->count && i < WORDS_MOST && used < sizeof list; i++) {
        names[i] = keys->rows[i].name;
        used +=
            (size_t)snprintf(list + used, sizeof list - used, "%s%s", i > 0 ? ", " : "", names[i]);
    }
    const char *nearest = nearest_word(name, names), *hint = scene_hint(name, scope->what);
    if (hint != NULL) {
        return scene_fail(scope->reader, member->at, "unknown key '%.40s' of the %s: %s", name,
                          scope->what, hint);
    }
    if (nearest != NULL) {
        return scene_fail(scope->reader, member->at,
                          "unknown key '%.40s' of the %s; did you mean '%s'? Allowed are %s", name,
                          scope->what, nearest, list);
    }
    return scene_fail(scope->reader, member->at, "unknown key '%.40s' of the %s; allowed are %s",
                      name, scope->what, list);
}

bool scene_read_keys(const struct scene_scope *scope, const struct scene_keys *keys, void *into) {
    const struct scene_value *group = scope->group;
    if (group->kind != VALUE_GROUP) {
        return group->kind != VALUE_REFUSED &&
               scene_fail(scope->reader, group->at, "the %s has to be a group { }, and is %s",
                          keys->what, type_name(group));
    }
    bool is_good = !group->is_partial, has_all_keys = is_good;
    for (size_t i = 0; i < group->count; i++) {
        const struct scene_key *row = keys->rows, *end = keys->rows + keys->count;
        while (row < end && strcmp(row->name, group->members[i].name) != 0) {
            row++;
        }
        bool is_read = row < end ? read_row(scope, row, &group->members[i],
                                            (unsigned char *)into + row->offset)
                                 : refuse_key(scope, keys, &group->members[i]);
        is_good = is_good && is_read;
        has_all_keys = has_all_keys && row < end;
    }
    /* A key that was refused may be meant as the one that is missing. */
    for (size_t i = 0; has_all_keys && i < keys->count; i++) {
        const struct scene_key *row = &keys->rows[i];
        if (row->is_required && value_member(group, row->name) == NULL) {
            is_good = scene_fail(scope->reader, group->at, "the %s lacks '%s', which is required",
                                 scope->what, row->name);
        }
    }
    return is_good;
}

const struct scene_value *scene_find_group(const struct scene_value *group, const char *key) {
    const struct scene_value *value = value_member(group, key);
    return value != NULL && value->kind == VALUE_GROUP ? value : NULL;
}

const struct scene_value *scene_find_list(const struct scene_value *group, const char *key) {
    const struct scene_value *value = value_member(group, key);
    return value != NULL && value_is_sequence(value) ? value : NULL;
}

struct scene_place scene_place_of(const struct scene_value *group, const char *key) {
    const struct scene_value *value = value_member(group, key);
    return (value != NULL ? value : group)->at;
}
