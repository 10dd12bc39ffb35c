/* SPDX-License-Identifier: MIT */
/* Values of a scene that are assigned from outside of its file. */
#include "scene/assign.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/nearest.h"

enum { STEP_SIZE = 64, NAMES_MOST = 200 };

static const struct scene_place nowhere = {0, 0};

/* Finds an element of a list by its number or its name; NULL: there is none. */
static struct scene_value *find_element(const struct scene_value *list, const char *step) {
    char *stop;
    unsigned long number = strtoul(step, &stop, 10);
    if (step[0] >= '0' && step[0] <= '9' && *stop == '\0') {
        return number < list->count ? &list->members[number] : NULL;
    }
    for (size_t i = 0; i < list->count; i++) {
        const struct scene_value *element = &list->members[i];
        const struct scene_value *name =
            element->kind == VALUE_GROUP ? value_member(element, "name") : NULL;
        if (name != NULL && name->kind == VALUE_STRING && strcmp(name->text, step) == 0) {
            return &list->members[i];
        }
    }
    return NULL;
}

static struct scene_value *find_member(const struct scene_value *value, const char *step) {
    if (value_is_sequence(value)) {
        return find_element(value, step);
    }
    for (size_t i = 0; value->kind == VALUE_GROUP && i < value->count; i++) {
        if (strcmp(value->members[i].name, step) == 0) {
            return &value->members[i];
        }
    }
    return NULL;
}

/* Says that a step leads nowhere, and what is there. */
static bool fail_step(struct scene_reader *reader, const char *assignment,
                      const struct scene_value *value, const char *step) {
    const char *names[NAMES_MOST + 1] = {NULL};
    const size_t count = value->kind == VALUE_GROUP && value->members != NULL ? value->count : 0;
    for (size_t i = 0; i < count && i < NAMES_MOST; i++) {
        names[i] = value->members[i].name;
    }
    const char *near = nearest_word(step, names);
    const int shown = (int)strcspn(assignment, "=");
    if (near != NULL) {
        return scene_fail(reader, value->at, "--set %.*s: there is no '%s'; did you mean '%s'?",
                          shown, assignment, step, near);
    }
    if (value_is_sequence(value)) {
        return scene_fail(reader, value->at,
                          "--set %.*s: no element '%s'; allowed is: 0 to %zu, or an element's name",
                          shown, assignment, step, value->count - (value->count > 0));
    }
    return scene_fail(reader, value->at, "--set %.*s: there is no '%s'", shown, assignment, step);
}

/* Reads what stands behind the '=' as the value of a key. */
static bool read_value(struct scene_reader *reader, const char *assignment, const char *key,
                       struct scene_value *value) {
    char text[1024];
    struct scene_value whole;
    const size_t before = reader->refusal_count;
    const char *given = strchr(assignment, '=') + 1;
    int length = snprintf(text, sizeof text, "%s = %s", key, given);
    if (length >= (int)sizeof text) {
        return scene_fail(reader, nowhere, "--set %.40s...: the value is too long", assignment);
    }
    scene_parse(reader, text, (size_t)length, &whole);
    if (reader->refusal_count > before || whole.count != 1) {
        reader->refusal_count = before; /* the places there are not the file's */
        return scene_fail(reader, nowhere,
                          "--set %.100s: '%.60s' is no value; allowed are numbers, \"text\", true, "
                          "false, [ ] and ( )",
                          assignment, given);
    }
    *value = whole.members[0];
    return true;
}

/* Adds a member to a group. */
static bool add_member(struct scene_reader *reader, struct scene_value *group,
                       const struct scene_value *member) {
    struct scene_value *members =
        memory_take(&reader->memory, (group->count + 1) * sizeof *members);
    if (members == NULL) {
        return scene_fail(reader, nowhere, "not enough memory to read the scene");
    }
    if (group->members != NULL) {
        memcpy(members, group->members, group->count * sizeof *members);
    }
    members[group->count] = *member;
    group->members = members;
    group->count++;
    return true;
}

/* Puts a value where the last step of the path leads. */
static bool put(struct scene_reader *reader, struct scene_value *at, const char *step,
                const char *assignment) {
    struct scene_value *old = find_member(at, step), value;
    const bool is_element = value_is_sequence(at);
    if (!read_value(reader, assignment, is_element ? "element" : step, &value)) {
        return false;
    }
    value.at = old != NULL ? old->at : at->at;
    if (is_element) {
        value.name = NULL;
    }
    if (old != NULL) {
        *old = value;
        return true;
    }
    return at->kind == VALUE_GROUP ? add_member(reader, at, &value)
                                   : fail_step(reader, assignment, at, step);
}

bool scene_assign(struct scene_reader *reader, struct scene_value *root, const char *assignment) {
    const char *stop = assignment + strcspn(assignment, "="), *begin = assignment;
    struct scene_value *at = root;
    for (;;) {
        char step[STEP_SIZE];
        size_t length = strcspn(begin, ".=");
        if (length == 0 || length >= sizeof step || *stop == '\0') {
            return scene_fail(reader, nowhere,
                              "--set %.100s: allowed is PATH=VALUE, as in materials.glass.ior=1.33",
                              assignment);
        }
        memcpy(step, begin, length);
        step[length] = '\0';
        if (begin + length == stop) {
            return put(reader, at, step, assignment);
        }
        struct scene_value *next = find_member(at, step);
        if (next == NULL) {
            return fail_step(reader, assignment, at, step);
        }
        at = next;
        begin += length + 1;
    }
}
