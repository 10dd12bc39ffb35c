/* SPDX-License-Identifier: MIT */
/* The help of a command: what it does, its options by group, and its examples. */
#include <string.h>

#include "options/options.h"

enum { TEXT_COLUMN = 27, LEFT_SIZE = 64 };

void help_print_wrapped(FILE *out, const char *words, unsigned at, unsigned left) {
    bool is_first = true;
    while (*words != '\0') {
        size_t length = strcspn(words, " ");
        if (!is_first && at + 1 + length > HELP_COLUMNS) {
            (void)fprintf(out, "\n%*s", (int)left, "");
            at = left;
            is_first = true;
        }
        (void)fprintf(out, "%s%.*s", is_first ? "" : " ", (int)length, words);
        at += (unsigned)length + !is_first;
        is_first = false;
        words += length;
        words += strspn(words, " ");
    }
    (void)fputc('\n', out);
}

/* Prints an option: its forms to the left, what it means and what it takes to the right. */
static void print_option(FILE *out, const struct option_entry *entry) {
    char left[LEFT_SIZE], letter[8] = "    ", allowed[OPTION_ALLOWED_SIZE];
    char help[OPTION_HELP_SIZE], right[OPTION_HELP_SIZE + OPTION_ALLOWED_SIZE + 16];
    if (entry->letter != 0) {
        (void)snprintf(letter, sizeof letter, "-%c, ", entry->letter);
    }
    int used = snprintf(left, sizeof left, "  %s--%s%s%s", letter, entry->name,
                        entry->value == NULL || option_is_optional(entry) ? "" : " ",
                        entry->value == NULL ? "" : entry->value);
    bool is_long = used + 1 > TEXT_COLUMN;
    allowed[0] = '\0'; /* that a file has a name is no news */
    if (entry->type != OPTION_TEXT && entry->type != OPTION_FOLDER) {
        option_allowed(entry, allowed);
    }
    option_help(entry, help);
    (void)snprintf(right, sizeof right, "%s%s%s", help, allowed[0] != '\0' ? "; allowed: " : "",
                   allowed);
    (void)fprintf(out, "%-*s", TEXT_COLUMN, left);
    if (is_long) {
        (void)fprintf(out, "\n%*s", TEXT_COLUMN, "");
    }
    help_print_wrapped(out, right, TEXT_COLUMN, TEXT_COLUMN);
}

/* Prints a group's options, under its title where the group before it had another one. */
static void print_group(FILE *out, const struct option_group *group, const char **title) {
    if (strcmp(*title, group->title) != 0) {
        *title = group->title;
        (void)fprintf(out, "\n%s:\n", *title);
    }
    for (const struct option_entry *entry = group->entries; entry->name != NULL; entry++) {
        print_option(out, entry);
    }
}

void command_print_help(FILE *out, const struct command *command) {
    const char *title = "";
    help_print_wrapped(out, command->summary, 0, 0);
    (void)fprintf(out, "\nusage: superframe %s%s%s [options]\n", command->name,
                  command->operands[0] != '\0' ? " " : "", command->operands);
    for (size_t i = 0; command->groups[i] != NULL; i++) {
        print_group(out, command->groups[i], &title);
    }
    print_group(out, &group_help, &title);
    (void)fputs("\nFor example:\n", out);
    for (size_t i = 0; command->examples[i] != NULL; i++) {
        (void)fprintf(out, "  superframe %s\n", command->examples[i]);
    }
}
