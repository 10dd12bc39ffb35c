/* SPDX-License-Identifier: MIT */
/* The groups of options that more than one command takes. */
#include "options/options_internal.h"
#include "render/arithmetic.h"

#define COUNT_MOST 4294967295.0

static const char *const tails[] = {"black", "estimate", NULL};
static const char *const highlights[] = {"phong", "blinn", NULL};
static const char *const profiles[] = {"1987", "later", NULL};
static const char *const pictures[] = {"screen", "memory", "whole", NULL};

/* ---- Results -------------------------------------------------------------------------------- */

const struct option_group group_result = {
    "Result", OPTION_ENTRIES({.name = "output",
                              .letter = 'o',
                              .value = "FILE",
                              TEXT_IN(struct options, output),
                              .role = ROLE_RESULT,
                              .allowed = "a file's name or -",
                              .help = "where the result goes; - is standard output"})};

const struct option_group group_picture = {
    "Result", OPTION_ENTRIES({.name = "output",
                              .letter = 'o',
                              .value = "FILE.png",
                              TEXT_IN(struct options, output),
                              .role = ROLE_PICTURE,
                              .allowed = "a file's name or -",
                              .help = "where the picture goes; - is standard output"},
                             {.name = "force",
                              FLAG_IN(struct options, force),
                              .help = "let the picture replace a file that is no PNG"})};

const struct option_group group_folder = {
    "Result", OPTION_ENTRIES({.name = "output",
                              .letter = 'o',
                              .value = "FOLDER",
                              FOLDER_IN(struct options, output),
                              .role = ROLE_RESULT,
                              .help = "where the results go; it is made if it is not there"})};

const struct option_group group_statistics = {
    "Result", OPTION_ENTRIES({.name = "stats",
                              .value = "FILE",
                              TEXT_IN(struct options, stats),
                              .role = ROLE_RESULT,
                              .allowed = "a file's name or -",
                              .help = "write statistics as JSON; - is standard output"})};

const struct option_group group_recording = {
    "Result", OPTION_ENTRIES({.name = "trace",
                              .value = "FILE",
                              TEXT_IN(struct options, trace),
                              .role = ROLE_RESULT,
                              .help = "record every port access as well"})};

/* ---- The scene ------------------------------------------------------------------------------ */

/* Each row's place, range and words stand once; what measure varies has other words of help. */
#define DEPTH_ENTRY                                                                                \
    .name = "depth", .value = "N", WHOLE_IN(struct options, overrides.depth, 0, SCENE_DEPTH_MOST), \
    OPTION_GIVEN(overrides.has_depth)
#define THRESHOLD_ENTRY                                                                            \
    .name = "threshold", .value = "E", REAL_IN(struct options, overrides.threshold, 0, 1),         \
    OPTION_GIVEN(overrides.has_threshold), .allowed = "a number or a fraction 0..1"
#define ERROR_ENTRY                                                                                \
    .name = "error", .value = "LSB",                                                               \
    REAL_IN(struct options, overrides.error, SCENE_ERROR_LEAST, 255),                              \
    OPTION_GIVEN(overrides.has_error)
#define SIZE_ENTRY                                                                                 \
    .name = "size", .value = "WxH", .type = OPTION_OWN, OPTION_GIVEN(overrides.has_size)
#define MODEL_ENTRY                                                                                \
    .name = "model", .value = "MODEL", .type = OPTION_OWN, OPTION_GIVEN(overrides.has_model),      \
    .set = set_model, .words = scene_model_words
#define COLOUR_ENTRY                                                                               \
    .name = "colour", .value = "MODE", .type = OPTION_OWN, OPTION_GIVEN(overrides.has_colour),     \
    .set = set_colour
#define TAIL_ENTRY                                                                                 \
    .name = "tail", .value = "KIND", WORD_IN(struct options, overrides.estimates, tails),          \
    OPTION_GIVEN(overrides.has_estimates)
#define HIGHLIGHT_ENTRY                                                                            \
    .name = "highlight", .value = "KIND",                                                          \
    WORD_IN(struct options, overrides.highlight, highlights),                                      \
    OPTION_GIVEN(overrides.has_highlight), .help = "how highlights are computed (the scene's)"
#define SEED_ENTRY                                                                                 \
    .name = "seed", .value = "S", WHOLE_IN(struct options, overrides.seed, 0, COUNT_MOST),         \
    OPTION_GIVEN(overrides.has_seed), .preset = "1", .help = "of the random dither"
#define ARITHMETIC_ENTRY                                                                           \
    .name = "arith", .value = "NAME", .type = OPTION_OWN, .set = set_arithmetic,                   \
    .words = arithmetics_names

#define SET_ENTRY                                                                                  \
    .name = "set", .value = "PATH=VALUE", .type = OPTION_OWN, .set = set_value,                    \
    .allowed = "up to 64 times, as in materials.glass.ior=1.33",                                   \
    .help = "any value of the scene file, by its keys with dots between"

const struct option_group group_scene = {
    "Scene",
    OPTION_ENTRIES(
        {DEPTH_ENTRY, .help = "the paper's depth level (the scene's)"},
        {THRESHOLD_ENTRY, .help = "the weight under which a branch ends (the scene's)"},
        {ERROR_ENTRY, .help = "the accuracy asked for, in levels, instead of a threshold (off)"},
        {SIZE_ENTRY, .set = set_size, .allowed = "1x1..640x400",
         .help = "the pixels rendered (the scene's)"},
        {MODEL_ENTRY, .help = "how light is reflected and refracted (the scene's)"},
        {COLOUR_ENTRY, .allowed = "full, bits:1..bits:8, dither or exposures",
         .help = "how colours are shown (the scene's)"},
        {TAIL_ENTRY, .help = "what a pruned branch counts as (black; estimate with --error)"},
        {HIGHLIGHT_ENTRY}, {SEED_ENTRY}, {SET_ENTRY})};

const struct option_group group_measured = {
    "What is varied otherwise",
    OPTION_ENTRIES(
        {ARITHMETIC_ENTRY, .help = "this arithmetic alone (fx, f32, f64 and two to compare with)"},
        {DEPTH_ENTRY, .help = "this depth level alone (eight, 1 to 64)"},
        {THRESHOLD_ENTRY, .help = "this threshold alone (none, and five from 1/256 to 1/65536)"},
        {ERROR_ENTRY, .help = "this accuracy asked for alone (4, 2, 1 and 0.5)"},
        {SIZE_ENTRY, .set = set_size, .allowed = "1x1..640x400",
         .help = "this size alone (160x100, and three others)"},
        {MODEL_ENTRY, .help = "this model alone (the scene's, and the two others)"},
        {COLOUR_ENTRY, .allowed = "full, bits:1..bits:8 or dither",
         .help = "these colours alone (full, and five others)"},
        {TAIL_ENTRY, .help = "this tail alone (both)"}, {HIGHLIGHT_ENTRY}, {SEED_ENTRY},
        {SET_ENTRY})};

const struct option_group group_arithmetic = {
    "Work",
    OPTION_ENTRIES({ARITHMETIC_ENTRY, .preset = "fx", .help = "the firmware's arithmetic"})};

const struct option_group group_small_size = {
    "Work", OPTION_ENTRIES(
                {SIZE_ENTRY, .set = set_small_size, .allowed = "1x1..320x200", .preset = "320x200",
                 .help = "of the small pictures; the large ones are twice as wide and high"})};

/* ---- Work ----------------------------------------------------------------------------------- */

const struct option_group group_jobs = {
    "Work", OPTION_ENTRIES({.name = "jobs",
                            .value = "J",
                            WHOLE_IN(struct options, jobs, 1, OPTIONS_JOBS_MOST),
                            .preset = "1",
                            .help = "worker threads"})};

const struct option_group group_quiet = {
    "Work",
    OPTION_ENTRIES({.name = "quiet", FLAG_IN(struct options, quiet), .help = "no progress bar"})};

/* ---- The board ------------------------------------------------------------------------------ */

#define PROFILE_ENTRY                                                                              \
    .name = "profile", .value = "BOARD", WORD_IN(struct options, board.profile, profiles),         \
    OPTION_GIVEN(board.has_profile)
#define BASE_ENTRY                                                                                 \
    .name = "base", .value = "PORT", .type = OPTION_OWN, OPTION_GIVEN(board.has_base),             \
    .set = set_base, .allowed = BOARD_BASES_TEXT

const struct option_group group_board = {
    "Board", OPTION_ENTRIES({PROFILE_ENTRY, .preset = "1987", .help = "which board"},
                            {BASE_ENTRY, .preset = "00D0", .help = "the jumper's base address"})};

const struct option_group group_board_of_trace = {
    "Board", OPTION_ENTRIES({PROFILE_ENTRY, .preset = "1987",
                             .help = "which board; a binary trace tells its own"},
                            {BASE_ENTRY, .preset = "00D0",
                             .help = "the jumper's base address; a binary trace tells its own"})};

const struct option_group group_screen = {
    "Board", OPTION_ENTRIES(
                 {.name = "picture",
                  .value = "KIND",
                  WORD_IN(struct options, board.picture, pictures),
                  .preset = "screen",
                  .help = "what the PNG shows: the CRT's picture, the frame memory, all of it"},
                 {.name = "native",
                  .value = "FILE.png",
                  TEXT_IN(struct options, board.native),
                  .role = ROLE_INPUT,
                  .allowed = "a PNG of 640x400, 16 colours of 4096",
                  .help = "the PC-9801's own screen, which the board's picture is laid under"},
                 {.name = "strict",
                  .value = "[=GRADE]",
                  .type = OPTION_OWN,
                  .set = set_strict,
                  .allowed = "P, D, S, I or A",
                  .help = "fail on violations; with a grade, also on whatever is no better known"},
                 {.name = "bus-wait",
                  .value = "NS",
                  REAL_IN(struct options, board.bus_wait, 0, 100000),
                  .preset = "0",
                  .help = "nanoseconds that the bus adds to each access, for the cost"},
                 {.name = "frame-seconds",
                  .value = "S",
                  REAL_IN(struct options, board.frame_seconds, 1e-6, 1e9),
                  .allowed = "a number 0.000001..1000000000",
                  .help = "what the whole frame takes, to tell the accesses' share of it"})};

const struct option_group group_faults = {
    "Board",
    OPTION_ENTRIES(
        {.name = "faults",
         .value = "LIST",
         .type = OPTION_OWN,
         .set = set_faults,
         .allowed = "seed=N, lose=N, flip=N, flip-read=N, dead=PORT, absent, vanish=N, lost, with "
                    "commas between",
         .help = "what goes wrong between program and board, one access in N"})};

const struct option_group group_stop = {
    "Board", OPTION_ENTRIES({.name = "stop",
                             .value = "K",
                             WHOLE_IN(struct options, board.stop, 1, COUNT_MOST),
                             .help = "stop after access K, counted from 1"})};

const struct option_group group_json = {
    "Result",
    OPTION_ENTRIES({.name = "json", FLAG_IN(struct options, json), .help = "print JSON"})};
