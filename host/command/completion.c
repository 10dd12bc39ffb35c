/* SPDX-License-Identifier: MIT */
/* superframe completion: what a shell needs to complete commands, options and their values. */
#include <string.h>

#include "command/command.h"
#include "scene/builtin.h"

/* ---- What is completed ---------------------------------------------------------------------- */

static void print_scenes(void) {
    for (size_t i = 0; i < builtin_scene_count; i++) {
        (void)printf("%s%s", i > 0 ? " " : "", builtin_scenes[i].name);
    }
}

static void print_options(const struct command *command) {
    const struct option_entry *entry;
    for (size_t i = 0; (entry = command_option(command, i)) != NULL; i++) {
        (void)printf("%s--%s", i > 0 ? " " : "", entry->name);
    }
}

static void print_words(const char *const *words) {
    for (size_t i = 0; words[i] != NULL; i++) {
        (void)printf("%s%s", i > 0 ? " " : "", words[i]);
    }
}

static bool takes_scenes(const struct command *command) {
    return command->kind == OPERANDS_SCENES || command->kind == OPERANDS_SCENE_FIRST;
}

/* Prints text for a shell's single quotes, with a backslash before letters that end a part. */
static void print_escaped(const char *text, const char *ends) {
    for (; *text != '\0'; text++) {
        if (*text == '\'') {
            (void)fputs("'\\''", stdout);
        } else {
            (void)printf("%s%c", strchr(ends, *text) != NULL ? "\\" : "", *text);
        }
    }
}

static void print_quoted(const char *text) {
    print_escaped(text, "");
}

/* ---- bash ----------------------------------------------------------------------------------- */

/* Prints the cases of options whose values are words. */
static void print_bash_values(void) {
    const struct option_entry *entry;
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        for (size_t j = 0; (entry = command_option(commands_built[i], j)) != NULL; j++) {
            if (entry->words != NULL) {
                (void)printf("    \"%s --%s\") words='", commands_built[i]->name, entry->name);
                print_words(entry->words);
                (void)fputs("' ;;\n", stdout);
            }
        }
    }
}

static void print_bash(void) {
    (void)fputs("# bash completion of superframe; made by superframe completion bash\n"
                "_superframe() {\n"
                "    local command=${COMP_WORDS[1]} word=$2 before=$3 words= scenes=\n"
                "    COMPREPLY=()\n"
                "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
                "        COMPREPLY=($(compgen -W '",
                stdout);
    print_words(commands_names);
    (void)fputs(" --help --version' -- \"$word\"))\n"
                "        return\n"
                "    fi\n"
                "    case \"$command $before\" in\n",
                stdout);
    print_bash_values();
    (void)fputs("    esac\n"
                "    if [ -n \"$words\" ]; then\n"
                "        COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
                "        return\n"
                "    fi\n"
                "    case $command in\n",
                stdout);
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        (void)printf("    %s) words='", commands_built[i]->name);
        print_options(commands_built[i]);
        (void)fputs("'", stdout);
        if (takes_scenes(commands_built[i])) {
            (void)fputs(" scenes='", stdout);
            print_scenes();
            (void)fputs("'", stdout);
        }
        (void)fputs(" ;;\n", stdout);
    }
    (void)fputs("    esac\n"
                "    case $word in\n"
                "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) ;;\n"
                "    *) COMPREPLY=($(compgen -W \"$scenes\" -- \"$word\") $(compgen -f -- "
                "\"$word\")) ;;\n"
                "    esac\n"
                "}\n"
                "complete -o filenames -F _superframe superframe\n",
                stdout);
}

/* ---- zsh ------------------------------------------------------------------------------------ */

static void print_zsh_option(const struct option_entry *entry) {
    char help[OPTION_HELP_SIZE];
    option_help(entry, help);
    (void)printf(" \\\n            '--%s%s[", entry->name,
                 entry->type == OPTION_FLAG  ? ""
                 : option_is_optional(entry) ? "=-"
                                             : "=");
    print_escaped(help, "[]:"); /* what ends a part of _arguments */
    (void)fputs("]", stdout);
    if (entry->words != NULL) {
        (void)printf(":%s:(", entry->name);
        print_words(entry->words);
        (void)fputs(")", stdout);
    } else if (entry->type != OPTION_FLAG) {
        (void)printf("%s:%s:%s", option_is_optional(entry) ? ":" : "", entry->name,
                     entry->role != ROLE_NONE || entry->type == OPTION_TEXT ||
                             entry->type == OPTION_FOLDER
                         ? "_files"
                         : " ");
    }
    (void)fputs("'", stdout);
}

static void print_zsh(void) {
    const struct option_entry *entry;
    (void)fputs("#compdef superframe\n"
                "# zsh completion of superframe; made by superframe completion zsh\n"
                "_superframe() {\n"
                "    if (( CURRENT == 2 )); then\n"
                "        local -a commands=(\n",
                stdout);
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        (void)printf("            '%s:", commands_built[i]->name);
        print_quoted(commands_built[i]->summary);
        (void)fputs("'\n", stdout);
    }
    (void)fputs("        )\n"
                "        _describe command commands\n"
                "        return\n"
                "    fi\n"
                "    shift words\n"
                "    (( CURRENT-- ))\n"
                "    case $words[1] in\n",
                stdout);
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        (void)printf("    %s)\n        _arguments -S", commands_built[i]->name);
        for (size_t j = 0; (entry = command_option(commands_built[i], j)) != NULL; j++) {
            print_zsh_option(entry);
        }
        if (takes_scenes(commands_built[i])) {
            (void)fputs(" \\\n            '*:scene:_alternative \"scenes:built-in scene:(", stdout);
            print_scenes();
            (void)fputs(")\" files:file:_files'", stdout);
        } else {
            (void)fputs(" '*:file:_files'", stdout);
        }
        (void)fputs(" ;;\n", stdout);
    }
    (void)fputs("    esac\n"
                "}\n"
                "if [ \"$funcstack[1]\" = _superframe ]; then\n"
                "    _superframe \"$@\"\n"
                "else\n"
                "    compdef _superframe superframe\n"
                "fi\n",
                stdout);
}

/* ---- fish ----------------------------------------------------------------------------------- */

static void print_fish_option(const struct command *command, const struct option_entry *entry) {
    char help[OPTION_HELP_SIZE];
    (void)printf("complete -c superframe -n '__fish_seen_subcommand_from %s' -l %s", command->name,
                 entry->name);
    if (entry->letter != 0) {
        (void)printf(" -s %c", entry->letter);
    }
    if (entry->words != NULL) {
        (void)fputs(" -x -a '", stdout);
        print_words(entry->words);
        (void)fputs("'", stdout);
    } else if (entry->type != OPTION_FLAG && !option_is_optional(entry)) {
        (void)fputs(" -r", stdout);
    }
    (void)fputs(" -d '", stdout);
    option_help(entry, help);
    print_quoted(help);
    (void)fputs("'\n", stdout);
}

static void print_fish(void) {
    const struct option_entry *entry;
    (void)fputs("# fish completion of superframe; made by superframe completion fish\n", stdout);
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct command *command = commands_built[i];
        (void)printf("complete -c superframe -n __fish_use_subcommand -f -a %s -d '",
                     command->name);
        print_quoted(command->summary);
        (void)fputs("'\n", stdout);
        if (takes_scenes(command)) {
            (void)printf("complete -c superframe -n '__fish_seen_subcommand_from %s' -a '",
                         command->name);
            print_scenes();
            (void)fputs("'\n", stdout);
        }
        for (size_t j = 0; (entry = command_option(command, j)) != NULL; j++) {
            print_fish_option(command, entry);
        }
    }
}

/* ---- The command ---------------------------------------------------------------------------- */

static int run_completion(const struct options *options) {
    static const struct {
        const char *name;
        void (*print)(void);
    } shells[] = {{"bash", print_bash}, {"zsh", print_zsh}, {"fish", print_fish}};
    for (size_t i = 0; i < sizeof shells / sizeof shells[0]; i++) {
        if (strcmp(options->operands[0], shells[i].name) == 0) {
            shells[i].print();
            return STATUS_DONE;
        }
    }
    return bad_input("completion: no shell \"%.100s\"; allowed is: bash, zsh or fish",
                     options->operands[0]);
}

const struct command command_completion = {
    .name = "completion",
    COMMAND_OPERANDS("SHELL", 1, 1, OPERANDS_NONE),
    .summary = "Print what bash, zsh or fish needs to complete command lines.",
    .groups = OPTION_GROUPS(NULL),
    .examples = COMMAND_EXAMPLES("completion bash > ~/.bash_completion",
                                 "completion fish > ~/.config/fish/completions/superframe.fish"),
    .run = run_completion};
