/* SPDX-License-Identifier: MIT */
/* The table of options: what each may be, and where it goes in struct options. */
#include "options/options.h"

#include <string.h>

#include "base/numbers.h"
#include "options/board_setters.h"
#include "render/arithmetic.h"
#include "usb_device.h"

#define BIT(command) (1u << COMMAND_##command)

enum {
    SCENE_READERS = BIT(RENDER) | BIT(CHECK) | BIT(COMPILE) | BIT(EXPORT) | BIT(TREE),
    BOARD_USERS = BIT(RENDER) | BIT(REPLAY) | BIT(BOOT),
    BOARD_WATCHERS = BOARD_USERS | BIT(TRACE),
    BOARD_MAKERS = BIT(RENDER) | BIT(BOOT) | BIT(ADAPTER),
    TRACE_READERS = BIT(REPLAY) | BIT(TRACE)
};

#define COUNT_MOST UINT64_C(1000000000000000)

static enum value_verdict verdict(bool is_allowed) {
    return is_allowed ? VALUE_TAKEN : VALUE_WRONG;
}

/* Finds the place of a value among words; -1: it is none of them. */
static int find_word(const char *value, const char *const *words) {
    for (int i = 0; words[i] != NULL; i++) {
        if (strcmp(value, words[i]) == 0) {
            return i;
        }
    }
    return -1;
}

/* Tells whether value is the word alone or "word:..." */
static bool is_kind(const char *value, const char *word) {
    size_t length = strlen(word);
    return strncmp(value, word, length) == 0 && (value[length] == '\0' || value[length] == ':');
}

static enum value_verdict set_help(struct options *options, const char *value) {
    (void)value;
    options->help = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_output(struct options *options, const char *value) {
    options->output = value;
    return verdict(value[0] != '\0');
}

/* Sets the folder of a command that writes many files, which can't go to standard output. */
static enum value_verdict set_folder(struct options *options, const char *value) {
    options->output = value;
    return verdict(value[0] != '\0' && strcmp(value, "-") != 0);
}

static enum value_verdict set_arithmetic(struct options *options, const char *value) {
    options->arithmetic = value;
    options->has_arithmetic = true;
    return arithmetic_is_missing(value) ? VALUE_NOT_BUILT : verdict(arithmetic_find(value) != NULL);
}

static enum value_verdict set_depth(struct options *options, const char *value) {
    uint64_t depth;
    if (!value_whole(value, 0, SCENE_DEPTH_MOST, &depth)) {
        return VALUE_WRONG;
    }
    options->overrides.has_depth = true;
    options->overrides.depth = (int)depth;
    return VALUE_TAKEN;
}

static enum value_verdict set_threshold(struct options *options, const char *value) {
    options->overrides.has_threshold = true;
    return verdict(value_real(value, 0, 1, &options->overrides.threshold));
}

static enum value_verdict set_error(struct options *options, const char *value) {
    options->overrides.has_error = true;
    return verdict(value_real(value, SCENE_ERROR_LEAST, 255, &options->overrides.error));
}

static enum value_verdict set_size(struct options *options, const char *value) {
    uint64_t width, height;
    if (!value_pair(value, 'x', 1, BOARD_WIDTH, BOARD_HEIGHT, &width, &height)) {
        return VALUE_WRONG;
    }
    options->overrides.has_size = true;
    options->overrides.width = (int)width;
    options->overrides.height = (int)height;
    return VALUE_TAKEN;
}

/* Sets the model. Absorption is a property of materials and goes with every model: the word alone
 * stands for the standard model. */
static enum value_verdict set_model(struct options *options, const char *value) {
    static const char *const words[] = {"simple", "fresnel", "wavelength", "absorption", NULL};
    static const enum scene_model models[] = {MODEL_SIMPLE, MODEL_FRESNEL, MODEL_WAVELENGTH,
                                              MODEL_FRESNEL};
    int word = find_word(value, words);
    options->overrides.has_model = true;
    options->overrides.model = models[word >= 0 ? word : 1];
    return verdict(word >= 0);
}

static enum value_verdict set_highlight(struct options *options, const char *value) {
    static const char *const words[] = {"phong", "blinn", NULL};
    int word = find_word(value, words);
    options->overrides.has_highlight = true;
    options->overrides.highlight = word == 1 ? HIGHLIGHT_BLINN : HIGHLIGHT_PHONG;
    return verdict(word >= 0);
}

static enum value_verdict set_colour(struct options *options, const char *value) {
    static const char *const words[] = {"full", "dither", "exposures", NULL};
    static const enum scene_colour colours[] = {COLOUR_FULL, COLOUR_DITHER, COLOUR_EXPOSURES};
    static const char bits[] = "bits:";
    uint64_t kept;
    int word = find_word(value, words);
    options->overrides.has_colour = true;
    if (strncmp(value, bits, sizeof bits - 1) == 0) {
        options->overrides.colour = COLOUR_BITS;
        if (!value_whole(value + sizeof bits - 1, 1, 8, &kept)) {
            return VALUE_WRONG;
        }
        options->overrides.colour_bits = (int)kept;
        return VALUE_TAKEN;
    }
    options->overrides.colour = colours[word >= 0 ? word : 0];
    return verdict(word >= 0);
}

static enum value_verdict set_seed(struct options *options, const char *value) {
    uint64_t seed;
    if (!value_whole(value, 0, UINT32_MAX, &seed)) {
        return VALUE_WRONG;
    }
    options->overrides.has_seed = true;
    options->overrides.seed = (uint32_t)seed;
    return VALUE_TAKEN;
}

static enum value_verdict set_keep_exposures(struct options *options, const char *value) {
    options->keep_exposures = value;
    return verdict(value[0] != '\0');
}

static enum value_verdict set_bus(struct options *options, const char *value) {
    static const char trace[] = "trace:";
    if (is_kind(value, "usb") || is_kind(value, "hid")) {
        options->bus = is_kind(value, "usb") ? BUS_CHOICE_USB : BUS_CHOICE_HID;
        options->adapter.serial = value[3] == ':' ? value + 4 : NULL;
        return verdict(value[3] == '\0' || value[4] != '\0');
    }
    if (strcmp(value, "ports") == 0) {
        options->bus = BUS_CHOICE_PORTS;
        return VALUE_TAKEN;
    }
    if (strncmp(value, trace, sizeof trace - 1) == 0) {
        options->bus = BUS_CHOICE_TRACE;
        options->bus_file = value + sizeof trace - 1;
        return verdict(options->bus_file[0] != '\0');
    }
    options->bus = BUS_CHOICE_EMULATOR;
    return verdict(strcmp(value, "emulator") == 0);
}

static enum value_verdict set_verify(struct options *options, const char *value) {
    uint64_t percent = 100;
    if (value != NULL && !value_whole(value, 1, 100, &percent)) {
        return VALUE_WRONG;
    }
    options->adapter.verify_percent = (unsigned)percent;
    return VALUE_TAKEN;
}

static enum value_verdict set_wait(struct options *options, const char *value) {
    (void)value;
    options->adapter.waits = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_serial(struct options *options, const char *value) {
    size_t length =
        strspn(value, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-");
    options->adapter.serial = value;
    return verdict(length >= 1 && length <= USB_SERIAL_MOST && value[length] == '\0');
}

static enum value_verdict set_listen(struct options *options, const char *value) {
    options->adapter.listen = value;
    return verdict(value[0] != '\0');
}

static enum value_verdict set_once(struct options *options, const char *value) {
    (void)value;
    options->adapter.once = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_trace(struct options *options, const char *value) {
    options->trace = value;
    return verdict(value[0] != '\0');
}

static enum value_verdict set_rows(struct options *options, const char *value) {
    uint64_t first, last;
    if (!value_pair(value, ':', 0, BOARD_HEIGHT, BOARD_HEIGHT, &first, &last) || first >= last) {
        return VALUE_WRONG;
    }
    options->has_rows = true;
    options->first_row = (unsigned)first;
    options->last_row = (unsigned)last;
    return VALUE_TAKEN;
}

static enum value_verdict set_profile(struct options *options, const char *value) {
    options->board.has_profile = true;
    return verdict(board_profile_from_text(value, &options->board.profile));
}

static enum value_verdict set_base(struct options *options, const char *value) {
    uint64_t base;
    if (!value_port(value, &base) || !board_base_is_offered((uint16_t)base)) {
        return VALUE_WRONG;
    }
    options->board.has_base = true;
    options->board.base = (uint16_t)base;
    return VALUE_TAKEN;
}

static enum value_verdict set_tail(struct options *options, const char *value) {
    static const char *const words[] = {"black", "estimate", NULL};
    int word = find_word(value, words);
    options->overrides.has_estimates = true;
    options->overrides.estimates = word == 1;
    return verdict(word >= 0);
}

static enum value_verdict set_jobs(struct options *options, const char *value) {
    uint64_t jobs;
    if (!value_whole(value, 1, OPTIONS_JOBS_MOST, &jobs)) {
        return VALUE_WRONG;
    }
    options->jobs = (unsigned)jobs;
    return VALUE_TAKEN;
}

static enum value_verdict set_stats(struct options *options, const char *value) {
    options->stats = value;
    return verdict(value[0] != '\0');
}

static enum value_verdict set_strict(struct options *options, const char *value) {
    options->board.strict = true;
    options->board.has_strict_grade = value != NULL;
    return verdict(value == NULL || board_grade_from_text(value, &options->board.strict_grade));
}

static enum value_verdict set_dot(struct options *options, const char *value) {
    (void)value;
    options->dot = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_cpu(struct options *options, const char *value) {
    (void)options;
    return verdict(strcmp(value, "386") == 0);
}

static enum value_verdict set_instructions(struct options *options, const char *value) {
    uint64_t most;
    if (!value_whole(value, 1, COUNT_MOST, &most)) {
        return VALUE_WRONG;
    }
    options->instructions_most = most;
    return VALUE_TAKEN;
}

static enum value_verdict set_escape(struct options *options, const char *value) {
    uint64_t after;
    if (!value_whole(value, 1, COUNT_MOST, &after)) {
        return VALUE_WRONG;
    }
    options->escape_after = after;
    return VALUE_TAKEN;
}

static enum value_verdict set_validate(struct options *options, const char *value) {
    (void)value;
    options->validates = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_minimal(struct options *options, const char *value) {
    (void)value;
    options->minimal = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_quiet(struct options *options, const char *value) {
    (void)value;
    options->quiet = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_within(struct options *options, const char *value) {
    uint64_t within;
    if (!value_whole(value, 0, 255, &within)) {
        return VALUE_WRONG;
    }
    options->within = (int)within;
    return VALUE_TAKEN;
}

static enum value_verdict set_share(struct options *options, const char *value) {
    return verdict(value_real(value, 0, 100, &options->share));
}

static enum value_verdict set_difference(struct options *options, const char *value) {
    options->difference = value;
    return verdict(value[0] != '\0');
}

static enum value_verdict set_signatures(struct options *options, const char *value) {
    options->signatures = value;
    return verdict(value[0] != '\0');
}

static enum value_verdict set_pov(struct options *options, const char *value) {
    (void)value;
    options->pov = true;
    return VALUE_TAKEN;
}

static enum value_verdict set_json(struct options *options, const char *value) {
    (void)value;
    options->json = true;
    return VALUE_TAKEN;
}

/* What the value of an option may be, for all commands that take it; its effect may differ between
 * them. */
#define DEPTHS     "a whole number 0..255"
#define THRESHOLDS "a number or a fraction 0..1"
#define ERRORS     "a number 0.01..255"
#define MODELS     "simple, fresnel, wavelength, absorption"
#define TAILS      "black or estimate"
#define PROFILES   "1987 or later"
#define BASES      "00D0, 02D0, 04D0, 06D0, 08D0, 0AD0 or 0CD0"

const struct option_entry option_table[] = {
    {"output", 'o', "FILE",
     BIT(RENDER) | BIT(COMPILE) | BIT(EXPORT) | TRACE_READERS | BIT(TREE) | BIT(BOOT), set_output,
     "a file's name or -", "where the result goes; - is standard output"},
    {"output", 'o', "FOLDER", BIT(MEASURE) | BIT(PAPER), set_folder, "a folder's name",
     "where the results go; it is made if it is not there"},
    {"output", 'o', "FILE.png", BIT(ADAPTER), set_output, "a file's name",
     "the board's picture when the adapter ends"},
    {"arith", 0, "NAME", BIT(RENDER) | BIT(TREE) | BIT(PAPER), set_arithmetic, arithmetics_names,
     "the firmware's arithmetic (fx)"},
    {"depth", 0, "N", SCENE_READERS, set_depth, DEPTHS, "the paper's depth level (the scene's)"},
    {"threshold", 0, "E", SCENE_READERS, set_threshold, THRESHOLDS,
     "the weight under which a branch ends (the scene's)"},
    {"error", 0, "LSB", SCENE_READERS, set_error, ERRORS,
     "the accuracy asked for, in levels, instead of a threshold (off)"},
    {"size", 0, "WxH", SCENE_READERS, set_size, "1x1..640x400",
     "the pixels rendered (the scene's)"},
    {"size", 0, "WxH", BIT(PAPER), set_size, "1x1..320x200",
     "of the small pictures; the large ones are twice as wide and high (320x200)"},
    {"model", 0, "MODEL", SCENE_READERS, set_model, MODELS,
     "how light is reflected and refracted (the scene's)"},
    {"colour", 0, "MODE", SCENE_READERS, set_colour, "full, bits:1..bits:8, dither or exposures",
     "how colours are shown (the scene's)"},
    {"tail", 0, "KIND", SCENE_READERS, set_tail, TAILS,
     "what a cut branch counts as (black; estimate with --error)"},
    /* What measure varies of its own accord. */
    {"arith", 0, "NAME", BIT(MEASURE), set_arithmetic, arithmetics_names,
     "this arithmetic alone (fx, f32, f64 and two to compare with)"},
    {"depth", 0, "N", BIT(MEASURE), set_depth, DEPTHS, "this depth level alone (eight, 1 to 64)"},
    {"threshold", 0, "E", BIT(MEASURE), set_threshold, THRESHOLDS,
     "this threshold alone (none, and five from 1/256 to 1/65536)"},
    {"error", 0, "LSB", BIT(MEASURE), set_error, ERRORS,
     "this accuracy asked for alone (4, 2, 1 and 0.5)"},
    {"size", 0, "WxH", BIT(MEASURE), set_size, "1x1..640x400",
     "this size alone (160x100, and three others)"},
    {"model", 0, "MODEL", BIT(MEASURE), set_model, MODELS,
     "this model alone (the scene's, and the two others)"},
    {"colour", 0, "MODE", BIT(MEASURE), set_colour, "full, bits:1..bits:8 or dither",
     "these colours alone (full, and five others)"},
    {"tail", 0, "KIND", BIT(MEASURE), set_tail, TAILS, "this tail alone (both)"},
    {"highlight", 0, "KIND", SCENE_READERS | BIT(MEASURE), set_highlight, "phong or blinn",
     "how highlights are computed (the scene's)"},
    {"seed", 0, "S", SCENE_READERS | BIT(MEASURE), set_seed, "a whole number 0..4294967295",
     "of the random dither (1)"},
    {"keep-exposures", 0, "FOLDER", BIT(RENDER), set_keep_exposures, "a folder's name",
     "write the eight 8-colour pictures of --colour exposures too"},
    {"bus", 0, "BUS", BIT(RENDER), set_bus,
     "emulator, trace:FILE, usb[:SERIAL], hid[:SERIAL] or ports",
     "where the port accesses go (emulator)"},
    {"trace", 0, "FILE", BIT(RENDER) | BIT(BOOT), set_trace, "a file's name",
     "record every port access as well"},
    {"rows", 0, "A:B", BIT(RENDER), set_rows, "A:B with 0 <= A < B <= 400",
     "only rows A..B-1; the others are not touched"},
    {"profile", 0, "BOARD", BOARD_MAKERS, set_profile, PROFILES, "which board (1987)"},
    {"profile", 0, "BOARD", TRACE_READERS, set_profile, PROFILES,
     "which board (that of the trace; of a text trace 1987)"},
    {"base", 0, "PORT", BOARD_MAKERS, set_base, BASES, "the jumper's base address (00D0)"},
    {"base", 0, "PORT", TRACE_READERS, set_base, BASES,
     "the jumper's base address (that of the trace; of a text trace 00D0)"},
    {"verify", 0, "[=PERCENT]", BIT(RENDER), set_verify, "a whole number 1..100",
     "read back what was drawn over USB or HID, or so many of its lines, and repair it"},
    {"wait", 0, NULL, BIT(RENDER), set_wait, "", "wait for an adapter, and for a lost one"},
    {"listen", 0, "ADDRESS[:PORT]", BIT(ADAPTER), set_listen, "an address in numbers, a port",
     "where clients may come from USB/IP (127.0.0.1:3240)"},
    {"serial", 0, "SERIAL", BIT(ADAPTER), set_serial, "1 to 31 letters, digits and dashes",
     "the virtual adapter's serial number (VIRTUAL)"},
    {"once", 0, NULL, BIT(ADAPTER), set_once, "", "end when the first client leaves"},
    {"yes-these-ports-are-mine", 0, NULL, BIT(RENDER), set_ports_are_mine, "",
     "let --bus ports open them: on a PC they belong to the DMA controller"},
    {"picture", 0, "KIND", BOARD_WATCHERS, set_picture, "screen, memory or whole",
     "what the PNG shows: the CRT's picture, the frame memory, all of it (screen)"},
    {"native", 0, "FILE.png", BOARD_WATCHERS, set_native, "a PNG of 640x400, 16 colours of 4096",
     "the PC-9801's own screen, which the board's picture is laid under"},
    {"faults", 0, "LIST", BOARD_USERS, set_faults, FAULTS_ALLOWED,
     "what goes wrong between program and board, one access in N"},
    {"stop", 0, "K", TRACE_READERS, set_stop, "a whole number 1..4294967295",
     "stop after access K, counted from 1"},
    {"bus-wait", 0, "NS", BOARD_WATCHERS, set_bus_wait, "a number 0..100000",
     "nanoseconds that the bus adds to each access, for the cost (0)"},
    {"frame-seconds", 0, "S", BOARD_WATCHERS, set_frame_seconds, "a number 0.000001..1000000000",
     "what the whole frame takes, to tell the accesses' share of it"},
    {"list", 0, NULL, BIT(TRACE), set_list, "", "print every access in words"},
    {"statistics", 0, NULL, BIT(TRACE), set_statistics, "",
     "print what was written how often, pixels touched, and what it costs"},
    {"violations", 0, NULL, BIT(TRACE), set_violations, "",
     "print each violation with the number of its access"},
    {"compare", 0, "TRACE", BIT(TRACE), set_against, "a file's name",
     "print the first difference from another trace; none: exit status 0, else 3"},
    {"to", 0, "FORM", BIT(TRACE), set_to, "binary or text", "convert to -o FILE"},
    {"jobs", 0, "J", BIT(RENDER) | BIT(MEASURE) | BIT(PAPER), set_jobs, "a whole number 1..256",
     "worker threads (1)"},
    {"stats", 0, "FILE", BOARD_USERS, set_stats, "a file's name or -",
     "write statistics as JSON; - is standard output"},
    {"strict", 0, "[=GRADE]", BOARD_WATCHERS, set_strict, "P, D, S, I or A",
     "fail on violations; with a grade, also on whatever is no better known"},
    {"within", 0, "LSB", BIT(COMPARE), set_within, "a whole number 0..255",
     "the difference that a channel may have (1)"},
    {"share", 0, "PERCENT", BIT(COMPARE), set_share, "a number 0..100",
     "the pixels that must be within it (99.9)"},
    {"json", 0, NULL, BIT(COMPARE), set_json, "", "print JSON"},
    {"difference", 0, "FILE.png", BIT(COMPARE), set_difference, "a file's name or -",
     "write a picture of where they differ: blue 1 LSB, green 2, yellow 4, red 9, white 33"},
    {"signatures", 0, "FILE", BIT(RENDER) | BIT(COMPARE), set_signatures, "a file's name",
     "a hash of each pixel's path: render writes FILE; compare reads it and one more"},
    {"dot", 0, NULL, BIT(TREE), set_dot, "", "a graph for Graphviz"},
    {"pov", 0, NULL, BIT(EXPORT), set_pov, "", "write source for POV-Ray 3.7"},
    {"validate", 0, NULL, BIT(CHECK), set_validate, "",
     "hold the tables against the scene after each step of the compiler; exit status 3 if not"},
    {"minimal", 0, NULL, BIT(COMPILE), set_minimal, "",
     "write the feature_set.h of an image for this scene alone"},
    {"cpu", 0, "CPU", BIT(BOOT), set_cpu, "386", "the CPU that runs the image (386)"},
    {"instructions", 0, "N", BIT(BOOT), set_instructions, "a whole number 1..1000000000000000",
     "end as failed after so many (200000000000)"},
    {"escape", 0, "N", BIT(BOOT), set_escape, "a whole number 1..1000000000000000",
     "press Esc when the keyboard has been asked N times"},
    {"quiet", 0, NULL, BIT(RENDER) | BIT(MEASURE) | BIT(PAPER) | BIT(BOOT), set_quiet, "",
     "no progress bar"},
    {"help", 0, NULL, ~0u, set_help, "", "print this text"},
    {NULL, 0, NULL, 0, NULL, NULL, NULL}};
