/* SPDX-License-Identifier: MIT */
/* Typed values of a group of a scene file; every refusal names the key and what is allowed. */
#include "scene/values.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/nearest.h"

const struct scene_range RANGE_LENGTH = {1e-9, 1e9};
const struct scene_range RANGE_COORDINATE = {-1e9, 1e9};
const struct scene_range RANGE_SHARE = {0, 1};
const struct scene_range RANGE_COLOUR = {0, 255};

enum { KEY_LIST_MOST = 400 };

static const char *type_name(const config_setting_t *setting) {
    switch (config_setting_type(setting)) {
    case CONFIG_TYPE_GROUP:
        return "a group { }";
    case CONFIG_TYPE_ARRAY:
        return "an array [ ]";
    case CONFIG_TYPE_LIST:
        return "a list ( )";
    case CONFIG_TYPE_STRING:
        return "a string";
    case CONFIG_TYPE_BOOL:
        return "true or false";
    default:
        return "a number";
    }
}

static bool fail_type(const struct scene_scope *scope, const char *key,
                      const config_setting_t *setting, const char *wanted) {
    return scene_fail(scope->reader, config_setting_source_line(setting),
                      "'%s' of the %s has to be %s, and is %s", key, scope->what, wanted,
                      type_name(setting));
}

/* Finds a key. NULL in *setting counts as a success where the key is optional. */
static bool find(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 const config_setting_t **setting) {
    *setting = config_setting_get_member(scope->group, key);
    if (*setting || presence == OPTIONAL) {
        return true;
    }
    return scene_fail(scope->reader, config_setting_source_line(scope->group),
                      "the %s lacks '%s', which is required", scope->what, key);
}

static bool is_number(const config_setting_t *setting) {
    int type = config_setting_type(setting);
    return type == CONFIG_TYPE_INT || type == CONFIG_TYPE_INT64 || type == CONFIG_TYPE_FLOAT;
}

static double number_of(const config_setting_t *setting) {
    switch (config_setting_type(setting)) {
    case CONFIG_TYPE_INT:
        return config_setting_get_int(setting);
    case CONFIG_TYPE_INT64:
        return (double)config_setting_get_int64(setting);
    default:
        return config_setting_get_float(setting);
    }
}

/* Checks that a value is in range. The comparison is written so that not-a-number fails it. */
static bool check_range(const struct scene_scope *scope, const char *key,
                        const config_setting_t *setting, struct scene_range range, double value) {
    if (value >= range.least && value <= range.most) {
        return true;
    }
    return scene_fail(scope->reader, config_setting_source_line(setting),
                      "'%s' of the %s is %.15g: %.10g to %.10g is allowed", key, scope->what, value,
                      range.least, range.most);
}

bool scope_number(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                  struct scene_range range, double *value) {
    const config_setting_t *setting;
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
                          const config_setting_t *setting, struct scene_range range, int count,
                          double *values) {
    int length = config_setting_length(setting);
    if (length != count) {
        return scene_fail(scope->reader, config_setting_source_line(setting),
                          "'%s' of the %s has to be %d numbers, and is %d%s", key, scope->what,
                          count, length,
                          length > count ? " (the decimal point is a dot, not a comma)" : "");
    }
    for (int i = 0; i < count; i++) {
        const config_setting_t *element = config_setting_get_elem(setting, (unsigned)i);
        if (!is_number(element)) {
            return scene_fail(scope->reader, config_setting_source_line(element),
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

static bool is_sequence(const config_setting_t *setting) {
    return config_setting_is_array(setting) || config_setting_is_list(setting);
}

bool scope_numbers(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                   struct scene_range range, int count, double *values) {
    const config_setting_t *setting;
    if (!find(scope, key, presence, &setting)) {
        return false;
    }
    if (!setting) {
        return true;
    }
    if (!is_sequence(setting)) {
        char wanted[40];
        snprintf(wanted, sizeof wanted, "%d numbers in [ ] or ( )", count);
        return fail_type(scope, key, setting, wanted);
    }
    return read_elements(scope, key, setting, range, count, values);
}

bool scope_three(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 struct scene_range range, double values[3]) {
    const config_setting_t *setting;
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
    if (!is_sequence(setting)) {
        return fail_type(scope, key, setting, "a number, or 3 numbers in [ ] or ( )");
    }
    return read_elements(scope, key, setting, range, 3, values);
}

bool scope_integer(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                   int least, int most, int *value) {
    double number = *value;
    const config_setting_t *setting = config_setting_get_member(scope->group, key);
    struct scene_range range = {least, most};
    if (!scope_number(scope, key, presence, range, &number)) {
        return false;
    }
    if (setting && floor(number) != number) {
        return scene_fail(scope->reader, config_setting_source_line(setting),
                          "'%s' of the %s is %.10g: a whole number, %d to %d, is allowed", key,
                          scope->what, number, least, most);
    }
    *value = (int)number;
    return true;
}

bool scope_boolean(const struct scene_scope *scope, const char *key, bool *value) {
    const config_setting_t *setting = config_setting_get_member(scope->group, key);
    if (!setting) {
        return true;
    }
    if (config_setting_type(setting) != CONFIG_TYPE_BOOL) {
        return fail_type(scope, key, setting, "true or false");
    }
    *value = config_setting_get_bool(setting) != 0;
    return true;
}

bool scope_string(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                  const char **value) {
    const config_setting_t *setting;
    if (!find(scope, key, presence, &setting)) {
        return false;
    }
    if (!setting) {
        return true;
    }
    if (config_setting_type(setting) != CONFIG_TYPE_STRING) {
        return fail_type(scope, key, setting, "a string in quotes");
    }
    *value = config_setting_get_string(setting);
    return true;
}

bool scope_group(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 const config_setting_t **group) {
    if (!find(scope, key, presence, group)) {
        return false;
    }
    if (*group && !config_setting_is_group(*group)) {
        return fail_type(scope, key, *group, "a group { }");
    }
    return true;
}

bool scope_list(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                int least, int most, const config_setting_t **list) {
    if (!find(scope, key, presence, list)) {
        return false;
    }
    if (!*list) {
        return true;
    }
    if (!is_sequence(*list)) {
        return fail_type(scope, key, *list, "a list ( )");
    }
    int length = config_setting_length(*list);
    if (length < least || length > most) {
        return scene_fail(scope->reader, config_setting_source_line(*list),
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
    return config_setting_get_member(scope->group, key) != NULL;
}

unsigned scope_line(const struct scene_scope *scope, const char *key) {
    const config_setting_t *setting = config_setting_get_member(scope->group, key);
    return config_setting_source_line(setting ? setting : scope->group);
}

bool scope_check_keys(const struct scene_scope *scope, const char *const *known) {
    for (int i = 0; i < config_setting_length(scope->group); i++) {
        const config_setting_t *setting = config_setting_get_elem(scope->group, (unsigned)i);
        const char *name = config_setting_name(setting);
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
        const char *nearest = nearest_word(name, known);
        unsigned line = config_setting_source_line(setting);
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

bool scene_is_group(struct scene_reader *reader, const config_setting_t *element,
                    const char *what) {
    if (config_setting_is_group(element)) {
        return true;
    }
    return scene_fail(reader, config_setting_source_line(element),
                      "the %s has to be a group { }, and is %s", what, type_name(element));
}
