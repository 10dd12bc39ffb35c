/* SPDX-License-Identifier: MIT */
/* Typed values of a group of a scene file; every refusal names the key and what is allowed. */
#include "scene/values.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/nearest.h"
#include "scene/hints.h"

const struct scene_range RANGE_LENGTH = {1e-9, 1e9};
const struct scene_range RANGE_COORDINATE = {-1e9, 1e9};
const struct scene_range RANGE_SHARE = {0, 1};
const struct scene_range RANGE_COLOUR = {0, 255};

enum { KEY_LIST_MOST = 400 };

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
        break;
    }
    return "a number";
}

static bool fail_type(const struct scene_scope *scope, const char *key,
                      const struct scene_value *setting, const char *wanted) {
    return scene_fail(scope->reader, setting->line, "'%s' of the %s has to be %s, and is %s", key,
                      scope->what, wanted, type_name(setting));
}

/* Finds a key. NULL in *setting counts as a success where the key is optional. */
static bool find(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 const struct scene_value **setting) {
    *setting = value_member(scope->group, key);
    if (*setting || presence == OPTIONAL) {
        return true;
    }
    return scene_fail(scope->reader, scope->group->line, "the %s lacks '%s', which is required",
                      scope->what, key);
}

/* Returns the number that a value is: a plain one, or one in parentheses; NULL: it is none. */
static const struct scene_value *number_in(const struct scene_value *value) {
    while (value->kind == VALUE_LIST && value->count == 1) {
        value = value->members;
    }
    return value->kind == VALUE_NUMBER ? value : NULL;
}

static bool is_number(const struct scene_value *value) {
    return number_in(value) != NULL;
}

static double number_of(const struct scene_value *value) {
    return number_in(value)->number;
}

/* Checks that a value is in range. The comparison is written so that not-a-number fails it. */
static bool check_range(const struct scene_scope *scope, const char *key,
                        const struct scene_value *setting, struct scene_range range, double value) {
    if (value >= range.least && value <= range.most) {
        return true;
    }
    return scene_fail(scope->reader, setting->line,
                      "'%s' of the %s is %.15g: %.10g to %.10g is allowed", key, scope->what, value,
                      range.least, range.most);
}

bool scope_number(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                  struct scene_range range, double *value) {
    const struct scene_value *setting;
    if (!find(scope, key, presence, &setting)) {
        return false;
    }
    if (!setting) {
        return true;
    }
    if (!is_number(setting)) {
        return fail_type(scope, key, setting, "a number");
    }
    double number = number_of(setting);
    if (!check_range(scope, key, setting, range, number)) {
        return false;
    }
    *value = number + 0.0; /* no negative zero */
    return true;
}

static bool read_elements(const struct scene_scope *scope, const char *key,
                          const struct scene_value *setting, struct scene_range range, int count,
                          double *values) {
    int length = (int)setting->count;
    if (length != count) {
        return scene_fail(scope->reader, setting->line,
                          "'%s' of the %s has to be %d numbers, and is %d%s", key, scope->what,
                          count, length,
                          length > count ? " (the decimal point is a dot, not a comma)" : "");
    }
    for (int i = 0; i < count; i++) {
        const struct scene_value *element = &setting->members[i];
        if (!is_number(element)) {
            return scene_fail(scope->reader, element->line,
                              "'%s' of the %s has to be %d numbers, and one is %s", key,
                              scope->what, count, type_name(element));
        }
        double number = number_of(element);
        if (!check_range(scope, key, element, range, number)) {
            return false;
        }
        values[i] = number + 0.0;
    }
    return true;
}

bool scope_numbers(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                   struct scene_range range, int count, double *values) {
    const struct scene_value *setting;
    if (!find(scope, key, presence, &setting)) {
        return false;
    }
    if (!setting) {
        return true;
    }
    if (!value_is_sequence(setting)) {
        char wanted[40];
        snprintf(wanted, sizeof wanted, "%d numbers in [ ] or ( )", count);
        return fail_type(scope, key, setting, wanted);
    }
    return read_elements(scope, key, setting, range, count, values);
}

bool scope_three(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 struct scene_range range, double values[3]) {
    const struct scene_value *setting;
    if (!find(scope, key, presence, &setting)) {
        return false;
    }
    if (!setting) {
        return true;
    }
    if (is_number(setting)) {
        if (!scope_number(scope, key, presence, range, &values[0])) {
            return false;
        }
        values[2] = values[1] = values[0];
        return true;
    }
    if (!value_is_sequence(setting)) {
        return fail_type(scope, key, setting, "a number, or 3 numbers in [ ] or ( )");
    }
    return read_elements(scope, key, setting, range, 3, values);
}

bool scope_integer(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                   int least, int most, int *value) {
    double number = *value;
    const struct scene_value *setting = value_member(scope->group, key);
    struct scene_range range = {least, most};
    if (!scope_number(scope, key, presence, range, &number)) {
        return false;
    }
    if (setting && floor(number) != number) {
        return scene_fail(scope->reader, setting->line,
                          "'%s' of the %s is %.10g: a whole number, %d to %d, is allowed", key,
                          scope->what, number, least, most);
    }
    *value = (int)number;
    return true;
}

bool scope_boolean(const struct scene_scope *scope, const char *key, bool *value) {
    const struct scene_value *setting = value_member(scope->group, key);
    if (!setting) {
        return true;
    }
    if (setting->kind != VALUE_BOOLEAN) {
        return fail_type(scope, key, setting, "true or false");
    }
    *value = setting->truth;
    return true;
}

bool scope_string(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                  const char **value) {
    const struct scene_value *setting;
    if (!find(scope, key, presence, &setting)) {
        return false;
    }
    if (!setting) {
        return true;
    }
    if (setting->kind != VALUE_STRING) {
        return fail_type(scope, key, setting, "a string in quotes");
    }
    *value = setting->text;
    return true;
}

bool scope_group(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 const struct scene_value **group) {
    if (!find(scope, key, presence, group)) {
        return false;
    }
    if (*group && (*group)->kind != VALUE_GROUP) {
        return fail_type(scope, key, *group, "a group { }");
    }
    return true;
}

bool scope_list(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                int least, int most, const struct scene_value **list) {
    if (!find(scope, key, presence, list)) {
        return false;
    }
    if (!*list) {
        return true;
    }
    if (!value_is_sequence(*list)) {
        return fail_type(scope, key, *list, "a list ( )");
    }
    int length = (int)(*list)->count;
    if (length < least || length > most) {
        return scene_fail(scope->reader, (*list)->line,
                          "'%s' of the %s has %d elements: %d to %d are allowed", key, scope->what,
                          length, least, most);
    }
    return true;
}

bool scope_choice(const struct scene_scope *scope, const char *key, const char *const *words,
                  int *index) {
    const char *word = NULL;
    if (!scope_string(scope, key, OPTIONAL, &word)) {
        return false;
    }
    if (!word) {
        return true;
    }
    char list[KEY_LIST_MOST] = "";
    size_t used = 0;
    for (int i = 0; words[i]; i++) {
        if (strcmp(words[i], word) == 0) {
            *index = i;
            return true;
        }
        used +=
            (size_t)snprintf(list + used, sizeof list - used, "%s\"%s\"", i ? ", " : "", words[i]);
    }
    return scene_fail(scope->reader, scope_line(scope, key),
                      "'%s' of the %s is \"%.40s\": %s are allowed", key, scope->what, word, list);
}

bool scope_has(const struct scene_scope *scope, const char *key) {
    return value_member(scope->group, key) != NULL;
}

unsigned scope_line(const struct scene_scope *scope, const char *key) {
    const struct scene_value *setting = value_member(scope->group, key);
    return (setting ? setting : scope->group)->line;
}

bool scope_check_keys(const struct scene_scope *scope, const char *const *known) {
    for (size_t i = 0; i < scope->group->count; i++) {
        const struct scene_value *setting = &scope->group->members[i];
        const char *name = setting->name;
        bool found = false;
        char list[KEY_LIST_MOST] = "";
        size_t used = 0;
        for (size_t j = 0; known[j] && used < sizeof list; j++) {
            found = found || strcmp(known[j], name) == 0;
            used +=
                (size_t)snprintf(list + used, sizeof list - used, "%s%s", j ? ", " : "", known[j]);
        }
        if (found) {
            continue;
        }
        const char *nearest = nearest_word(name, known), *hint = scene_hint(name, scope->what);
        unsigned line = setting->line;
        if (hint) {
            return scene_fail(scope->reader, line, "unknown key '%.40s' of the %s: %s", name,
                              scope->what, hint);
        }
        if (nearest) {
            return scene_fail(scope->reader, line,
                              "unknown key '%.40s' of the %s; did you mean '%s'? Allowed are %s",
                              name, scope->what, nearest, list);
        }
        return scene_fail(scope->reader, line, "unknown key '%.40s' of the %s; allowed are %s",
                          name, scope->what, list);
    }
    return true;
}

bool scene_is_group(struct scene_reader *reader, const struct scene_value *element,
                    const char *what) {
    if (element->kind == VALUE_GROUP) {
        return true;
    }
    return scene_fail(reader, element->line, "the %s has to be a group { }, and is %s", what,
                      type_name(element));
}
