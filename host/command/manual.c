/* SPDX-License-Identifier: MIT */
/* superframe manual: all commands and options, as a page for man. */
#include <ctype.h>
#include <string.h>

#include "command/command.h"

/* Prints source of the page, and in the place of its % a text, of which troff changes no letter. */
static void print(const char *source, const char *text) {
    static const char special[] = "-\\'`^~";
    static const char *const escapes[] = {"\\-", "\\e", "\\(aq", "\\(ga", "\\(ha", "\\(ti"};
    size_t before = strcspn(source, "%");
    (void)fwrite(source, 1, before, stdout);
    for (; *text != '\0'; text++) {
        const char *found = strchr(special, *text);
        if (found != NULL) {
            (void)fputs(escapes[found - special], stdout);
        } else {
            (void)fputc(*text, stdout);
        }
    }
    (void)fputs(source + before + 1, stdout);
}

/* Prints an option: its forms, what it means, what is allowed, and what holds without it. */
static void print_option(const struct option_entry *entry) {
    char allowed[OPTION_ALLOWED_SIZE];
    (void)fputs(".TP\n", stdout);
    if (entry->letter != 0) {
        (void)printf("\\fB\\-%c\\fR, ", entry->letter);
    }
    print("\\fB\\-\\-%\\fR", entry->name);
    if (entry->value != NULL) {
        print(option_is_optional(entry) ? "\\fI%\\fR" : " \\fI%\\fR", entry->value);
    }
    (void)printf("\n%c", toupper((unsigned char)entry->help[0]));
    print("%.\n", entry->help + 1);
    option_allowed(entry, allowed);
    if (allowed[0] != '\0' && entry->type != OPTION_TEXT && entry->type != OPTION_FOLDER) {
        print("Allowed: %.\n", allowed);
    }
    if (entry->preset != NULL) {
        print("Default: %.\n", entry->preset);
    }
}

static void print_options(const struct option_group *group) {
    for (const struct option_entry *entry = group->entries; entry->name != NULL; entry++) {
        print_option(entry);
    }
}

/* Finds the command that takes a group as number n of all commands that do; NULL: there are fewer.
 */
static const struct command *find_user(const struct option_group *group, size_t n) {
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct option_group *const *taken = commands_built[i]->groups;
        while (*taken != NULL && *taken != group) {
            taken++;
        }
        if (*taken != NULL && n-- == 0) {
            return commands_built[i];
        }
    }
    return NULL;
}

static bool is_shared(const struct option_group *group) {
    return find_user(group, 1) != NULL;
}

/* ---- Sections ------------------------------------------------------------------------------- */

/* Prints a command: what it does, the options that it alone takes, the subjects of its others, and
 * its examples. */
static void print_command(const struct command *command) {
    const char *title = "";
    print(".SS superframe %", command->name);
    print(command->operands[0] != '\0' ? " %\n" : "%\n", command->operands);
    print("%\n", command->summary);
    for (size_t i = 0; command->groups[i] != NULL; i++) {
        if (!is_shared(command->groups[i])) {
            print_options(command->groups[i]);
        }
    }
    for (size_t i = 0; command->groups[i] != NULL; i++) {
        if (is_shared(command->groups[i]) && strcmp(title, command->groups[i]->title) != 0) {
            print(title[0] == '\0' ? ".PP\nOptions, below: %" : ", %", command->groups[i]->title);
            title = command->groups[i]->title;
        }
    }
    (void)printf("%s.PP\nFor example:\n.PP\n.nf\n", title[0] != '\0' ? ".\n" : "");
    for (size_t i = 0; command->examples[i] != NULL; i++) {
        print("superframe %\n", command->examples[i]);
    }
    (void)fputs(".fi\n", stdout);
}

/* Prints a group, under its title where the group before it had another one, and who takes it. */
static void print_shared(const struct option_group *group, const char **title) {
    const struct command *user;
    if (strcmp(*title, group->title) != 0) {
        *title = group->title;
        print(".SS %\n", *title);
    }
    for (size_t n = 0; (user = find_user(group, n)) != NULL; n++) {
        print(n == 0 ? ".PP\nOf %" : ", %", user->name);
    }
    (void)fputs(":\n", stdout);
    print_options(group);
}

static int run_manual(const struct options *options) {
    const char *title = "";
    (void)options;
    (void)fputs(".TH SUPERFRAME 1 \"\" \"superframe " SUPERFRAME_VERSION "\" \"User Commands\"\n"
                ".SH NAME\n"
                "superframe \\- ray tracer and emulator for the PC\\-9801 SuperFrame board\n"
                ".SH SYNOPSIS\n"
                "\\fBsuperframe\\fR \\fICOMMAND\\fR [\\fIoperands\\fR] [\\fIoptions\\fR]\n"
                ".br\n"
                "\\fBsuperframe\\fR \\fB\\-\\-help\\fR | \\fB\\-\\-version\\fR\n"
                ".SH COMMANDS\n",
                stdout);
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        print_command(commands_built[i]);
    }
    (void)fputs(".SH OPTIONS\n", stdout);
    print_options(&group_help);
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct option_group *const *group = commands_built[i]->groups;
        for (; *group != NULL; group++) {
            if (is_shared(*group) && find_user(*group, 0) == commands_built[i]) {
                print_shared(*group, &title);
            }
        }
    }
    return STATUS_DONE;
}

const struct command command_manual = {
    .name = "manual",
    .operands = "",
    .summary = "Print all commands and options as a page for man.",
    .groups = OPTION_GROUPS(NULL),
    .examples = COMMAND_EXAMPLES("manual | man -l -", "manual > superframe.1"),
    .run = run_manual};
