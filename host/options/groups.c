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

static const struct option_entry result_entries[] = {
    {.name = "output",
     .letter = 'o',
     .value = "FILE",
     .type = OPTION_TEXT,
     OPTION_MEMBER(output),
     .role = ROLE_RESULT,
     .allowed = "a file's name or -",
     .help = "where the result goes; - is standard output"},
    {.name = NULL}};
const struct option_group group_result = {"Result", result_entries};

static const struct option_entry picture_entries[] = {
    {.name = "output",
     .letter = 'o',
     .value = "FILE.png",
     .type = OPTION_TEXT,
     OPTION_MEMBER(output),
     .role = ROLE_PICTURE,
     .allowed = "a file's name or -",
     .help = "where the picture goes; - is standard output"},
    {.name = "force",
     .type = OPTION_FLAG,
     OPTION_MEMBER(force),
     .help = "let the picture replace a file that is no PNG"},
    {.name = NULL}};
const struct option_group group_picture = {"Result", picture_entries};

static const struct option_entry folder_entries[] = {
    {.name = "output",
     .letter = 'o',
     .value = "FOLDER",
     .type = OPTION_FOLDER,
     OPTION_MEMBER(output),
     .role = ROLE_RESULT,
     .help = "where the results go; it is made if it is not there"},
    {.name = NULL}};
const struct option_group group_folder = {"Result", folder_entries};

static const struct option_entry statistics_entries[] = {
    {.name = "stats",
     .value = "FILE",
     .type = OPTION_TEXT,
     OPTION_MEMBER(stats),
     .role = ROLE_RESULT,
     .allowed = "a file's name or -",
     .help = "write statistics as JSON; - is standard output"},
    {.name = NULL}};
const struct option_group group_statistics = {"Result", statistics_entries};

static const struct option_entry recording_entries[] = {
    {.name = "trace",
     .value = "FILE",
     .type = OPTION_TEXT,
     OPTION_MEMBER(trace),
     .role = ROLE_RESULT,
     .help = "record every port access as well"},
    {.name = NULL}};
const struct option_group group_recording = {"Result", recording_entries};

/* ---- The scene ------------------------------------------------------------------------------ */

/* Each row's place, range and words stand once; what measure varies has other words of help. */
#define DEPTH_ENTRY                                                                                \
    .name = "depth", .value = "N", .type = OPTION_WHOLE, OPTION_MEMBER(overrides.depth),           \
    OPTION_GIVEN(overrides.has_depth), .most = SCENE_DEPTH_MOST
#define THRESHOLD_ENTRY                                                                            \
    .name = "threshold", .value = "E", .type = OPTION_REAL, OPTION_MEMBER(overrides.threshold),    \
    OPTION_GIVEN(overrides.has_threshold), .most = 1, .allowed = "a number or a fraction 0..1"
#define ERROR_ENTRY                                                                                \
    .name = "error", .value = "LSB", .type = OPTION_REAL, OPTION_MEMBER(overrides.error),          \
    OPTION_GIVEN(overrides.has_error), .least = SCENE_ERROR_LEAST, .most = 255
#define SIZE_ENTRY                                                                                 \
    .name = "size", .value = "WxH", .type = OPTION_OWN, OPTION_GIVEN(overrides.has_size),          \
    .set = set_size
#define MODEL_ENTRY                                                                                \
    .name = "model", .value = "MODEL", .type = OPTION_OWN, OPTION_GIVEN(overrides.has_model),      \
    .set = set_model, .allowed = "simple, fresnel, wavelength or absorption"
#define COLOUR_ENTRY                                                                               \
    .name = "colour", .value = "MODE", .type = OPTION_OWN, OPTION_GIVEN(overrides.has_colour),     \
    .set = set_colour
#define TAIL_ENTRY                                                                                 \
    .name = "tail", .value = "KIND", .type = OPTION_WORD, OPTION_MEMBER(overrides.estimates),      \
    OPTION_GIVEN(overrides.has_estimates), .words = tails
#define HIGHLIGHT_ENTRY                                                                            \
    .name = "highlight", .value = "KIND", .type = OPTION_WORD, OPTION_MEMBER(overrides.highlight), \
    OPTION_GIVEN(overrides.has_highlight), .words = highlights,                                    \
    .help = "how highlights are computed (the scene's)"
#define SEED_ENTRY                                                                                 \
    .name = "seed", .value = "S", .type = OPTION_WHOLE, OPTION_MEMBER(overrides.seed),             \
    OPTION_GIVEN(overrides.has_seed), .most = COUNT_MOST, .help = "of the random dither (1)"
#define ARITHMETIC_ENTRY                                                                           \
    .name = "arith", .value = "NAME", .type = OPTION_OWN, OPTION_GIVEN(has_arithmetic),            \
    .set = set_arithmetic, .allowed = arithmetics_names

#define SET_ENTRY                                                                                  \
    .name = "set", .value = "PATH=VALUE", .type = OPTION_OWN, .set = set_value,                    \
    .allowed = "up to 64 times, as in materials.glass.ior=1.33",                                   \
    .help = "any value of the scene file, by its keys with dots between"

static const struct option_entry scene_entries[] = {
    {DEPTH_ENTRY, .help = "the paper's depth level (the scene's)"},
    {THRESHOLD_ENTRY, .help = "the weight under which a branch ends (the scene's)"},
    {ERROR_ENTRY, .help = "the accuracy asked for, in levels, instead of a threshold (off)"},
    {SIZE_ENTRY, .allowed = "1x1..640x400", .help = "the pixels rendered (the scene's)"},
    {MODEL_ENTRY, .help = "how light is reflected and refracted (the scene's)"},
    {COLOUR_ENTRY, .allowed = "full, bits:1..bits:8, dither or exposures",
     .help = "how colours are shown (the scene's)"},
    {TAIL_ENTRY, .help = "what a cut branch counts as (black; estimate with --error)"},
    {HIGHLIGHT_ENTRY},
    {SEED_ENTRY},
    {SET_ENTRY},
    {.name = NULL}};
const struct option_group group_scene = {"Scene", scene_entries};

static const struct option_entry measured_entries[] = {
    {ARITHMETIC_ENTRY, .help = "this arithmetic alone (fx, f32, f64 and two to compare with)"},
    {DEPTH_ENTRY, .help = "this depth level alone (eight, 1 to 64)"},
    {THRESHOLD_ENTRY, .help = "this threshold alone (none, and five from 1/256 to 1/65536)"},
    {ERROR_ENTRY, .help = "this accuracy asked for alone (4, 2, 1 and 0.5)"},
    {SIZE_ENTRY, .allowed = "1x1..640x400", .help = "this size alone (160x100, and three others)"},
    {MODEL_ENTRY, .help = "this model alone (the scene's, and the two others)"},
    {COLOUR_ENTRY, .allowed = "full, bits:1..bits:8 or dither",
     .help = "these colours alone (full, and five others)"},
    {TAIL_ENTRY, .help = "this tail alone (both)"},
    {HIGHLIGHT_ENTRY},
    {SEED_ENTRY},
    {SET_ENTRY},
    {.name = NULL}};
const struct option_group group_measured = {"What is varied otherwise", measured_entries};

static const struct option_entry arithmetic_entries[] = {
    {ARITHMETIC_ENTRY, .help = "the firmware's arithmetic (fx)"}, {.name = NULL}};
const struct option_group group_arithmetic = {"Work", arithmetic_entries};

static const struct option_entry small_size_entries[] = {
    {SIZE_ENTRY, .allowed = "1x1..320x200",
     .help = "of the small pictures; the large ones are twice as wide and high (320x200)"},
    {.name = NULL}};
const struct option_group group_small_size = {"Work", small_size_entries};

/* ---- Work ----------------------------------------------------------------------------------- */

static const struct option_entry jobs_entries[] = {{.name = "jobs",
                                                    .value = "J",
                                                    .type = OPTION_WHOLE,
                                                    OPTION_MEMBER(jobs),
                                                    .least = 1,
                                                    .most = OPTIONS_JOBS_MOST,
                                                    .help = "worker threads (1)"},
                                                   {.name = NULL}};
const struct option_group group_jobs = {"Work", jobs_entries};

static const struct option_entry quiet_entries[] = {
    {.name = "quiet", .type = OPTION_FLAG, OPTION_MEMBER(quiet), .help = "no progress bar"},
    {.name = NULL}};
const struct option_group group_quiet = {"Work", quiet_entries};

/* ---- The board ------------------------------------------------------------------------------ */

#define PROFILE_ENTRY                                                                              \
    .name = "profile", .value = "BOARD", .type = OPTION_WORD, OPTION_MEMBER(board.profile),        \
    OPTION_GIVEN(board.has_profile), .words = profiles
#define BASE_ENTRY                                                                                 \
    .name = "base", .value = "PORT", .type = OPTION_OWN, OPTION_GIVEN(board.has_base),             \
    .set = set_base, .allowed = BOARD_BASES_TEXT

static const struct option_entry board_entries[] = {
    {PROFILE_ENTRY, .help = "which board (1987)"},
    {BASE_ENTRY, .help = "the jumper's base address (00D0)"},
    {.name = NULL}};
const struct option_group group_board = {"Board", board_entries};

static const struct option_entry board_of_trace_entries[] = {
    {PROFILE_ENTRY, .help = "which board (that of the trace; of a text trace 1987)"},
    {BASE_ENTRY, .help = "the jumper's base address (that of the trace; of a text trace 00D0)"},
    {.name = NULL}};
const struct option_group group_board_of_trace = {"Board", board_of_trace_entries};

static const struct option_entry screen_entries[] = {
    {.name = "picture",
     .value = "KIND",
     .type = OPTION_WORD,
     OPTION_MEMBER(board.picture),
     .words = pictures,
     .help = "what the PNG shows: the CRT's picture, the frame memory, all of it (screen)"},
    {.name = "native",
     .value = "FILE.png",
     .type = OPTION_TEXT,
     OPTION_MEMBER(board.native),
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
     .type = OPTION_REAL,
     OPTION_MEMBER(board.bus_wait),
     .most = 100000,
     .help = "nanoseconds that the bus adds to each access, for the cost (0)"},
    {.name = "frame-seconds",
     .value = "S",
     .type = OPTION_REAL,
     OPTION_MEMBER(board.frame_seconds),
     .least = 1e-6,
     .most = 1e9,
     .allowed = "a number 0.000001..1000000000",
     .help = "what the whole frame takes, to tell the accesses' share of it"},
    {.name = NULL}};
const struct option_group group_screen = {"Board", screen_entries};

static const struct option_entry faults_entries[] = {
    {.name = "faults",
     .value = "LIST",
     .type = OPTION_OWN,
     .set = set_faults,
     .allowed = "seed=N, lose=N, flip=N, flip-read=N, dead=PORT, absent, vanish=N, lost, with "
                "commas between",
     .help = "what goes wrong between program and board, one access in N"},
    {.name = NULL}};
const struct option_group group_faults = {"Board", faults_entries};

static const struct option_entry stop_entries[] = {{.name = "stop",
                                                    .value = "K",
                                                    .type = OPTION_WHOLE,
                                                    OPTION_MEMBER(board.stop),
                                                    .least = 1,
                                                    .most = COUNT_MOST,
                                                    .help = "stop after access K, counted from 1"},
                                                   {.name = NULL}};
const struct option_group group_stop = {"Board", stop_entries};

static const struct option_entry json_entries[] = {
    {.name = "json", .type = OPTION_FLAG, OPTION_MEMBER(json), .help = "print JSON"},
    {.name = NULL}};
const struct option_group group_json = {"Result", json_entries};
