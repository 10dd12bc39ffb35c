/* SPDX-License-Identifier: MIT */
/* What the tables of options say: which options a command takes, and their values. */
#include <stdarg.h>
#include <string.h>

#include "base/numbers.h"
#include "options/options_internal.h"

const struct option_group group_help = {
    "Help",
    OPTION_ENTRIES(
        {.name = "help", .letter = 'h', FLAG_IN(struct options, help), .help = "print this help"})};

bool options_refuse(struct options_error *error, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return false;
}

bool option_is_optional(const struct option_entry *entry) {
    return entry->value != NULL && entry->value[0] == '[';
}

const struct option_entry *command_option(const struct command *command, size_t i) {
    for (size_t j = 0; command->groups[j] != NULL; j++) {
        const struct option_entry *entry = command->groups[j]->entries;
        for (; entry->name != NULL; entry++) {
            if (i-- == 0) {
                return entry;
            }
        }
    }
    return i == 0 ? group_help.entries : NULL;
}

/* ---- Values --------------------------------------------------------------------------------- */

/* Stores a whole number in a member, whose type is known by its size. */
static void store_whole(const struct option_entry *entry, uint64_t value, struct options *options) {
    unsigned char *member = (unsigned char *)options + entry->offset;
    const bool is_true = value != 0;
    const unsigned number = (unsigned)value;
    if (entry->size == sizeof value) {
        memcpy(member, &value, sizeof value);
    } else if (entry->size == sizeof number) {
        memcpy(member, &number, sizeof number);
    } else if (entry->size == sizeof is_true) {
        memcpy(member, &is_true, sizeof is_true);
    }
}

int option_word(const char *value, const char *const *words) {
    int i = 0;
    while (words[i] != NULL && strcmp(value, words[i]) != 0) {
        i++;
    }
    return words[i] != NULL ? i : -1;
}

static enum value_verdict take_by_type(const struct option_entry *entry, const char *value,
                                       struct options *options) {
    unsigned char *member = (unsigned char *)options + entry->offset;
    uint64_t whole = 1;
    double real;
    int word;
    bool is_right = true;
    switch (entry->type) {
    case OPTION_FLAG:
        break;
    case OPTION_TEXT:
    case OPTION_FOLDER:
        memcpy(member, &value, sizeof value);
        return option_verdict(value[0] != '\0' &&
                              (entry->type == OPTION_TEXT || strcmp(value, "-") != 0));
    case OPTION_WHOLE:
        is_right = value_whole(value, (uint64_t)entry->least, (uint64_t)entry->most, &whole);
        break;
    case OPTION_REAL:
        is_right = value_real(value, entry->least, entry->most, &real);
        if (is_right) {
            memcpy(member, &real, sizeof real);
        }
        return option_verdict(is_right);
    case OPTION_WORD:
        word = option_word(value, entry->words);
        is_right = word >= 0;
        whole = (uint64_t)word;
        break;
    case OPTION_OWN:
        return entry->set(options, value);
    }
    if (is_right) {
        store_whole(entry, whole, options);
    }
    return option_verdict(is_right);
}

void option_preset(const struct option_entry *entry, struct options *options) {
    if (entry->preset != NULL) {
        (void)take_by_type(entry, entry->preset, options);
    }
}

enum value_verdict option_take(const struct option_entry *entry, const char *value,
                               struct options *options) {
    const bool is_given = true;
    if (entry->given != 0) {
        memcpy((unsigned char *)options + entry->given, &is_given, sizeof is_given);
    }
    return take_by_type(entry, value, options);
}

void option_help(const struct option_entry *entry, char text[OPTION_HELP_SIZE]) {
    const char *preset = entry->preset;
    (void)snprintf(text, OPTION_HELP_SIZE, "%s%s%s%s", entry->help, preset != NULL ? " (" : "",
                   preset != NULL ? preset : "", preset != NULL ? ")" : "");
}

/* Writes words as a sentence has them: "a, b or c". */
static void list_words(const char *const *words, char text[OPTION_ALLOWED_SIZE]) {
    size_t used = 0;
    for (size_t i = 0; words[i] != NULL && used < OPTION_ALLOWED_SIZE; i++) {
        const char *before = i == 0 ? "" : words[i + 1] == NULL ? " or " : ", ";
        used += (size_t)snprintf(text + used, OPTION_ALLOWED_SIZE - used, "%s%s", before, words[i]);
    }
}

void option_allowed(const struct option_entry *entry, char text[OPTION_ALLOWED_SIZE]) {
    text[0] = '\0';
    if (entry->allowed != NULL) {
        (void)snprintf(text, OPTION_ALLOWED_SIZE, "%s", entry->allowed);
    } else if (entry->words != NULL) {
        list_words(entry->words, text);
    } else if (entry->type == OPTION_TEXT || entry->type == OPTION_FOLDER) {
        (void)snprintf(text, OPTION_ALLOWED_SIZE, "a %s's name",
                       entry->type == OPTION_TEXT ? "file" : "folder");
    } else if (entry->type == OPTION_WHOLE) {
        (void)snprintf(text, OPTION_ALLOWED_SIZE, "a whole number %.0f..%.0f", entry->least,
                       entry->most);
    } else if (entry->type == OPTION_REAL) {
        (void)snprintf(text, OPTION_ALLOWED_SIZE, "a number %.10g..%.10g", entry->least,
                       entry->most);
    }
}
