/* SPDX-License-Identifier: MIT */
/* The command line as data: options in groups, and commands that take groups. The parser, the help,
 * the manual page and the completion of shells come from these tables. */
#ifndef SUPERFRAME_OPTIONS_H
#define SUPERFRAME_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "adapter/options.h"
#include "board.h"
#include "board/options.h"
#include "scene/overrides.h"

enum bus_choice {
    BUS_CHOICE_EMULATOR,
    BUS_CHOICE_TRACE,
    BUS_CHOICE_PORTS,
    BUS_CHOICE_USB,
    BUS_CHOICE_HID
};

/* Says where the port accesses go. */
struct bus_options {
    enum bus_choice choice;
    const char *file; /* of trace:FILE */
    bool ports_are_mine;
    struct adapter_options adapter;
};

/* Holds what the groups fill that several commands take. A member is 0 or NULL where a command
 * takes no such group. Strings point into argv. A command with options of its own has a struct that
 * begins with this one. */
struct options {
    char **operands; /* what is no option */
    int operand_count;
    bool help;

    const char *output; /* -o; NULL: not given; "-": standard output */
    bool force;         /* a picture may replace what is no picture */
    bool converts;      /* what goes to -o is no picture, but another form of what is read */
    const char *stats;  /* NULL: none; "-": standard output */
    const char *trace;  /* NULL: none */
    bool json;
    const char *arithmetic; /* a name that arithmetic_find() knows; NULL: not given to measure */
    struct scene_overrides overrides;
    struct board_options board;
    struct bus_options bus;
    unsigned jobs; /* 1..OPTIONS_JOBS_MOST */
    bool quiet;
};

enum { OPTIONS_JOBS_MOST = 256 };

/* Why a command line is refused. */
struct options_error {
    char text[512];
};

/* ---- Options -------------------------------------------------------------------------------- */

/* What an option's value turned out to be. */
enum value_verdict { VALUE_TAKEN, VALUE_WRONG, VALUE_NOT_BUILT };

/* How an option's value is read, and what its member of struct options is. */
enum option_type {
    OPTION_FLAG,   /* bool; the option takes no value */
    OPTION_TEXT,   /* const char *: any text but "" */
    OPTION_FOLDER, /* const char *: any text but "" and "-" */
    OPTION_WHOLE,  /* unsigned, int or uint64_t, by its size: least..most */
    OPTION_REAL,   /* double, least..most; a fraction will do */
    OPTION_WORD,   /* bool or an enum, by its size: the place among words */
    OPTION_OWN     /* set() reads it */
};

/* What an option that names a file means to that file. */
enum option_role {
    ROLE_NONE,
    ROLE_RESULT,   /* it is written */
    ROLE_PICTURE,  /* it is written, as a PNG */
    ROLE_INPUT,    /* it is read */
    ROLE_EXPOSURES /* the folder of the eight pictures of a multiple exposure */
};

/* One option. Zero or NULL: there is no such thing. */
struct option_entry {
    const char *name;  /* without the dashes */
    char letter;       /* of the short form */
    const char *value; /* what the help calls the value; "[=X]": may be left out */
    enum option_type type;
    size_t offset, size; /* of its member in struct options, or in the command's own struct */
    size_t given;        /* offset of the bool that says the option was given */
    const char *preset;  /* the value where the option is not given */
    double least, most;
    const char *const *words; /* ended by NULL */
    enum value_verdict (*set)(struct options *options, const char *value);
    enum option_role role;
    const char *shown;   /* what messages about files call the option, if not by its name */
    const char *allowed; /* what the value may be; NULL: as type, range and words say */
    const char *help;
};

/* The place of an option's member, for the tables: in a command's own struct, or in struct options.
 * The types have their own words. */
#define OPTION_MEMBER_OF(type_, member)                                                            \
    .offset = offsetof(type_, member), .size = sizeof((type_ *)0)->member
#define FLAG_IN(type_, member)   .type = OPTION_FLAG, OPTION_MEMBER_OF(type_, member)
#define TEXT_IN(type_, member)   .type = OPTION_TEXT, OPTION_MEMBER_OF(type_, member)
#define FOLDER_IN(type_, member) .type = OPTION_FOLDER, OPTION_MEMBER_OF(type_, member)
#define WORD_IN(type_, member, list)                                                               \
    .type = OPTION_WORD, OPTION_MEMBER_OF(type_, member), .words = (list)
#define WHOLE_IN(type_, member, from, to)                                                          \
    .type = OPTION_WHOLE, OPTION_MEMBER_OF(type_, member), .least = (from), .most = (to)
#define REAL_IN(type_, member, from, to)                                                           \
    .type = OPTION_REAL, OPTION_MEMBER_OF(type_, member), .least = (from), .most = (to)
#define OPTION_GIVEN(member) .given = offsetof(struct options, member)

/* Options that belong together. */
struct option_group {
    const char *title;                  /* "Scene" */
    const struct option_entry *entries; /* ended by one without a name */
};

/* Lists for the descriptions of groups and commands, with what ends them. */
/* clang-format off */
#define OPTION_ENTRIES(...) (const struct option_entry[]){__VA_ARGS__, {0}}
#define OPTION_GROUPS(...) (const struct option_group *const[]){__VA_ARGS__, NULL}
#define COMMAND_EXAMPLES(...) (const char *const[]){__VA_ARGS__, NULL}
/* clang-format on */
#define COMMAND_OPERANDS(words, at_least, at_most, of)                                             \
    .operands = (words), .least = (at_least), .most = (at_most), .kind = (of)

/* The groups that more than one command takes; groups.c has them. Two are of one subject where the
 * same options say something else to other commands. */
extern const struct option_group group_result;     /* -o FILE */
extern const struct option_group group_picture;    /* -o FILE.png, --force */
extern const struct option_group group_folder;     /* -o FOLDER */
extern const struct option_group group_scene;      /* what a scene's settings may become */
extern const struct option_group group_measured;   /* the same settings, for measure */
extern const struct option_group group_arithmetic; /* --arith */
extern const struct option_group group_small_size; /* --size, for paper */
extern const struct option_group group_jobs;       /* --jobs */
extern const struct option_group group_quiet;      /* --quiet */
extern const struct option_group group_board;      /* --profile, --base of a board that is made */
extern const struct option_group group_board_of_trace; /* the same where traces may say it */
extern const struct option_group group_screen;         /* --picture, --native, --strict, costs */
extern const struct option_group group_faults;         /* --faults */
extern const struct option_group group_statistics;     /* --stats */
extern const struct option_group group_recording;      /* --trace */
extern const struct option_group group_stop;           /* --stop */
extern const struct option_group group_json;           /* --json */
extern const struct option_group group_help;           /* --help, which every command takes */

/* ---- Commands ------------------------------------------------------------------------------- */

/* What the operands of a command are. */
enum operand_kind { OPERANDS_NONE, OPERANDS_SCENES, OPERANDS_SCENE_FIRST, OPERANDS_FILES };

/* A sub-command. Its file ends in its description. */
struct command {
    const char *name;
    const char *operands; /* for the usage line; "": there are none */
    const char *summary;  /* one sentence */
    int least, most;      /* how many operands it takes */
    size_t size; /* of its own struct, which begins with a struct options; 0: it has none */
    enum operand_kind kind;
    const struct option_group *const *groups; /* ended by NULL */
    const char *const *examples; /* command lines without "superframe "; ended by NULL */

    /* Returns the name of the result that is written where -o is not given, perhaps in `buffer`;
     * NULL: none. The member may be NULL. */
    const char *(*default_output)(const struct options *options, char *buffer, size_t size);

    /* Names what goes to standard output besides the results of options; NULL: nothing. The member
     * may be NULL. */
    const char *(*printed)(const struct options *options);

    /* Checks what the command needs, and what excludes what. Returns false with *error filled. The
     * member may be NULL. */
    bool (*check)(const struct options *options, struct options_error *error);

    int (*run)(const struct options *options); /* returns an exit status */
};

/* ---- Reading a command line ----------------------------------------------------------------- */

/* Reads what stands after the sub-command's name; argv[0] is that name. argv is permuted: options
 * may stand anywhere. Returns the command's own struct, or a struct options if it has none; the
 * caller frees it. NULL with *error filled where the command line is refused, or memory is out. */
struct options *options_parse(const struct command *command, int argc, char **argv,
                              struct options_error *error);

/* Fills *error, and returns false. */
bool options_refuse(struct options_error *error, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* Returns the verdict on a value that is allowed or not. */
static inline enum value_verdict option_verdict(bool is_allowed) {
    return is_allowed ? VALUE_TAKEN : VALUE_WRONG;
}

/* Puts a value into an option's member, and where there is one into that which says it was given.
 */
enum value_verdict option_take(const struct option_entry *entry, const char *value,
                               struct options *options);

/* Puts into an option's member the value that holds where the option is not given. */
void option_preset(const struct option_entry *entry, struct options *options);

enum { OPTION_ALLOWED_SIZE = 160, OPTION_HELP_SIZE = 160 };

/* Writes what an option means, with its preset in brackets. */
void option_help(const struct option_entry *entry, char text[OPTION_HELP_SIZE]);

/* Writes what an option's value may be; "" for a flag. */
void option_allowed(const struct option_entry *entry, char text[OPTION_ALLOWED_SIZE]);

/* Returns entry i of all groups of a command, --help the last; NULL beyond that. */
const struct option_entry *command_option(const struct command *command, size_t i);

/* Tells whether the value of an option may be left out, as in "--strict[=GRADE]". */
bool option_is_optional(const struct option_entry *entry);

/* Prints what a command does, its options by group, and its examples, in at most 80 columns. */
void command_print_help(FILE *out, const struct command *command);

/* The columns of a page of help. */
enum { HELP_COLUMNS = 80 };

/* Prints words, from column `at` on, in lines of at most HELP_COLUMNS that begin at column `left`.
 * Ends the last line. */
void help_print_wrapped(FILE *out, const char *words, unsigned at, unsigned left);

#endif
