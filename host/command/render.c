/* SPDX-License-Identifier: MIT */
/* superframe render: a scene through firmware, ports and board to a picture. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "adapter/open.h"
#include "base/interrupt.h"
#include "base/numbers.h"
#include "base/output.h"
#include "base/stopwatch.h"
#include "board/camera.h"
#include "board/session.h"
#include "board_ports.h"
#include "command/command.h"
#include "options/bus.h"
#include "ports_linux.h"
#include "render/arithmetic.h"
#include "render/progress.h"
#include "render/remarks.h"
#include "render/render.h"
#include "render/signatures.h"
#include "scene/load.h"
#include "stats/run.h"

enum { NAME_SIZE = 256 };

/* Holds the options that `render` alone takes. */
struct render_options {
    struct options common;
    bool has_rows;
    unsigned first_row, last_row; /* rows first .. last-1 */
    const char *keep_exposures;   /* a folder; NULL: none */
    const char *signatures;       /* NULL: none */
};

/* One run of the command. What it holds is freed whatever happens. */
struct render_run {
    const struct options *options;
    const struct render_options *own; /* the same */
    struct compiled_scene *compiled;
    struct ports_linux ports;   /* of --bus ports */
    struct adapter_bus adapter; /* of --bus usb and hid */
    struct session session;
    struct camera *camera; /* NULL: the scene is not shown by exposures, or to no board */
    struct output signatures;
    char default_name[NAME_SIZE];
    struct render_totals totals;
};

/* Names the picture where -o is not given; NULL: there is no picture. */
static const char *default_output(const struct options *options, char *buffer, size_t size) {
    if (options->bus.choice != BUS_CHOICE_EMULATOR) {
        return NULL;
    }
    scene_picture_name(options->operands[0], buffer, size);
    return buffer;
}

/* Opens all results before the work begins: a name that can't be written is known at once. */
static int open_results(struct render_run *run) {
    const struct options *options = run->options;
    const struct session_files files = {
        .picture = options->output != NULL ? options->output
                                           : default_output(options, run->default_name, NAME_SIZE),
        .trace = options->bus.choice == BUS_CHOICE_TRACE ? options->bus.file : options->trace,
        .stats = options->stats};
    int status = session_open(&run->session, &files);
    if (status == STATUS_DONE && run->own->signatures != NULL &&
        !output_open(&run->signatures, run->own->signatures)) {
        status = STATUS_FAILED;
    }
    return status;
}

static int open_camera(struct render_run *run) {
    const char *folder = run->own->keep_exposures;
    if (run->compiled->show != SHOW_EXPOSURES) {
        return folder == NULL ? STATUS_DONE
                              : bad_input("--keep-exposures goes with --colour exposures only");
    }
    if (run->options->bus.choice == BUS_CHOICE_EMULATOR) {
        run->camera = camera_new(folder);
        return run->camera != NULL ? STATUS_DONE : STATUS_FAILED;
    }
    return STATUS_DONE;
}

/* Opens the machine's own ports, and gives up what rights the program has besides. */
static int open_own_ports(struct ports_linux *ports, uint16_t base) {
    char message[PORTS_LINUX_MESSAGE_SIZE];
    switch (ports_linux_open(ports, base, &ports_linux_system, message)) {
    case PORTS_LINUX_OPEN:
        return STATUS_DONE;
    case PORTS_LINUX_OWNED:
        return bad_input("--bus ports: %s", message);
    case PORTS_LINUX_REFUSED:
        break;
    }
    return failure("--bus ports: %s", message);
}

static int load(struct render_run *run) {
    const struct options *options = run->options;
    struct scene_error error;
    run->compiled = load_compiled_scene(options->operands[0], &options->overrides, &error);
    if (run->compiled == NULL) {
        return bad_input("%s", error.text);
    }
    if (run->own->has_rows && run->own->last_row > run->compiled->height) {
        return bad_input("--rows %u:%u: the picture has %u rows; allowed is: up to 0:%u",
                         run->own->first_row, run->own->last_row, run->compiled->height,
                         run->compiled->height);
    }
    return STATUS_DONE;
}

/* Prints which rows are on the board behind the adapter, after a failure. */
static void explain_adapter(const void *context) {
    const struct render_run *run = context;
    const struct compiled_scene *compiled = run->compiled;
    adapter_bus_explain(&run->adapter, run->own->has_rows ? run->own->first_row : 0,
                        run->own->has_rows ? run->own->last_row : compiled->height,
                        board_dots_a_pixel(compiled->width, compiled->height));
}

/* Begins the session with what --bus asks for at the end of the buses. */
static int begin_session(struct render_run *run) {
    const struct options *options = run->options;
    struct session_device device = {NULL, NULL, NULL};
    int status = STATUS_DONE;
    switch (options->bus.choice) {
    case BUS_CHOICE_EMULATOR:
        return session_begin(&run->session, &options->board, NULL);
    case BUS_CHOICE_TRACE:
        break;
    case BUS_CHOICE_PORTS:
        device.bus = &run->ports.bus;
        break;
    case BUS_CHOICE_USB:
    case BUS_CHOICE_HID:
        status =
            adapter_bus_open(&run->adapter, options->bus.choice == BUS_CHOICE_HID ? "hid" : "usb",
                             options->board.base, &options->bus.adapter);
        if (status != STATUS_DONE) {
            return status;
        }
        device.bus = &run->adapter.usb->bus;
        device.explain = explain_adapter;
        device.context = run;
        break;
    }
    return session_begin(&run->session, &options->board, &device);
}

/* Opens the machine's own ports first, since rights are given up with them. */
static int prepare(struct render_run *run) {
    const struct options *options = run->options;
    int status = options->bus.choice == BUS_CHOICE_PORTS
                     ? open_own_ports(&run->ports, options->board.base)
                     : STATUS_DONE;
    if (status == STATUS_DONE) {
        status = load(run);
    }
    if (status == STATUS_DONE) {
        status = begin_session(run);
    }
    if (status == STATUS_DONE) {
        status = open_camera(run);
    }
    return status == STATUS_DONE ? open_results(run) : status;
}

/* Photographs the screen, where a camera stands before it. */
static void take_exposure(void *context, unsigned exposure) {
    struct render_run *run = context;
    port_chain_picture(run->session.chain);
    camera_take(run->camera, run->session.chain->rgb, exposure);
}

static int render_rows(struct render_run *run) {
    const struct options *options = run->options;
    struct progress progress;
    struct scene_error error;
    struct render_job job;
    memset(&job, 0, sizeof job);
    job.arithmetic = arithmetic_find(options->arithmetic);
    job.scene = run->compiled;
    job.base = options->board.base;
    job.first_row = run->own->has_rows ? run->own->first_row : 0;
    job.last_row = run->own->has_rows ? run->own->last_row : run->compiled->height;
    job.jobs = options->jobs;
    job.stop = interrupt_noted();
    job.progress = progress_show;
    job.context = &progress;
    job.exposed = run->camera != NULL ? take_exposure : NULL;
    job.exposed_context = run;
    remarks_complain(run->compiled, job.arithmetic);
    progress_begin(&progress, job.last_row - job.first_row, options->quiet);
    interrupt_catch();
    (void)bus_bind(session_bus(&run->session));
    bool is_rendered = render(&job, &run->totals, &error);
    progress_end(&progress);
    return is_rendered ? STATUS_DONE : bad_input("%s", error.text);
}

/* Reads back what an adapter's board holds, where --verify asks for it. */
static bool verify(struct render_run *run) {
    const unsigned percent = run->options->bus.adapter.verify_percent;
    if (percent == 0 ||
        adapter_bus_verify(&run->adapter, percent, run->options->overrides.seed) == STATUS_DONE) {
        return true;
    }
    if (run->adapter.usb->bus.status != BUS_OK) {
        explain_adapter(run);
    }
    return false;
}

/* Writes the screen's picture, or the camera's where the scene is shown by exposures. */
static bool write_picture(struct render_run *run) {
    struct camera *camera = run->camera;
    if (camera == NULL) {
        return session_commit_picture(&run->session);
    }
    camera_develop(camera);
    const struct shown_picture photograph = {camera->rgb, PICTURE_WIDTH, PICTURE_HEIGHT};
    return camera_commit(camera) && picture_sink_finish(run->session.picture, &photograph);
}

static int write_results(struct render_run *run) {
    const struct run_stats stats = {.session = &run->session,
                                    .scene = run->options->operands[0],
                                    .arithmetic = run->options->arithmetic,
                                    .compiled = run->compiled,
                                    .totals = &run->totals,
                                    .adapter = run->adapter.usb != NULL ? &run->adapter : NULL,
                                    .photograph = run->camera != NULL ? run->camera->rgb : NULL};
    int status = session_end_accesses(&run->session);
    if (status == STATUS_DONE && *interrupt_noted() != 0 &&
        !session_divert_picture(&run->session)) {
        status = STATUS_FAILED;
    }
    if (status == STATUS_DONE && !(verify(run) && write_picture(run) && stats_commit(&stats))) {
        status = STATUS_FAILED;
    }
    return status;
}

/* Follows once more the trees of the rows that were drawn, for --signatures. */
static int write_signatures(struct render_run *run) {
    struct signatures signatures;
    struct scene_error error;
    const unsigned first = run->own->has_rows ? run->own->first_row : 0;
    const struct signature_job job = {.arithmetic = arithmetic_find(run->options->arithmetic),
                                      .scene = run->compiled,
                                      .first_row = first,
                                      .last_row = first + run->totals.rows,
                                      .jobs = run->options->jobs,
                                      .stop = interrupt_noted()};
    if (run->signatures.file == NULL) {
        return STATUS_DONE;
    }
    memset(&signatures, 0, sizeof signatures);
    if (!signatures_make(&job, &signatures, &error)) {
        return bad_input("%s", error.text);
    }
    errno = 0;
    int status =
        output_finish(&run->signatures, signatures_write(&signatures, run->signatures.file));
    signatures_free(&signatures);
    return status;
}

/* Says on a terminal where the picture is. */
static void tell_place(const struct render_run *run) {
    const char *name = run->session.files.picture;
    if (name != NULL && strcmp(name, "-") != 0 && !run->options->quiet &&
        isatty(STDERR_FILENO) == 1) {
        (void)fprintf(stderr, "The picture is %s\n", name);
    }
}

/* Tells of pixels that are not as accurate as --error asks. Returns STATUS_NOT_HELD if there are
 * any and --strict is asked for. */
static int judge_accuracy(const struct render_run *run) {
    remarks_complain_of_error(run->compiled, &run->totals);
    return run->options->board.strict && run->totals.unreached_pixels > 0 ? STATUS_NOT_HELD
                                                                          : STATUS_DONE;
}

/* Returns the exit status of a finished run: whether it was interrupted, and whether --strict
 * holds. */
static int judge(struct render_run *run) {
    if (*interrupt_noted() != 0) {
        const char *partial = run->session.partial_name;
        complain("interrupted after %u rows%s%s", run->totals.rows,
                 partial != NULL ? "; what was drawn is in " : "", partial != NULL ? partial : "");
        return STATUS_SIGNAL + *interrupt_noted();
    }
    tell_place(run);
    const int accuracy = judge_accuracy(run), board = session_judge(&run->session);
    return board != STATUS_DONE ? board : accuracy;
}

static int run_render(const struct options *options) {
    static int (*const steps[])(struct render_run *) = {prepare, render_rows, write_results,
                                                        write_signatures, judge};
    struct render_run run;
    memset(&run, 0, sizeof run);
    run.options = options;
    run.own = (const struct render_options *)options;
    run.session.began = stopwatch_start();
    int status = STATUS_DONE;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0] && status == STATUS_DONE; i++) {
        status = steps[i](&run);
    }
    output_discard(&run.signatures);
    camera_free(run.camera);
    session_free(&run.session);
    adapter_bus_close(&run.adapter);
    compiled_scene_free(run.compiled);
    return status;
}

/* ---- The command ---------------------------------------------------------------------------- */

static enum value_verdict set_rows(struct options *options, const char *value) {
    struct render_options *own = (struct render_options *)options;
    uint64_t first, last;
    if (!value_pair(value, ':', 0, BOARD_HEIGHT, BOARD_HEIGHT, &first, &last) || first >= last) {
        return VALUE_WRONG;
    }
    own->has_rows = true;
    own->first_row = (unsigned)first;
    own->last_row = (unsigned)last;
    return VALUE_TAKEN;
}

static bool check_render(const struct options *options, struct options_error *error) {
    bool keeps = ((const struct render_options *)options)->keep_exposures != NULL;
    if (keeps && options->bus.choice == BUS_CHOICE_TRACE) {
        return options_refuse(error, "--keep-exposures goes with --bus emulator only; a trace has "
                                     "no board behind it");
    }
    return bus_check(options, error);
}

static const struct option_group group_own = {
    "Result",
    OPTION_ENTRIES({.name = "rows",
                    .value = "A:B",
                    .type = OPTION_OWN,
                    .set = set_rows,
                    .allowed = "A:B with 0 <= A < B <= 400",
                    .help = "only rows A..B-1; the others are not touched"},
                   {.name = "signatures",
                    .value = "FILE",
                    TEXT_IN(struct render_options, signatures),
                    .role = ROLE_RESULT,
                    .help = "write a hash of each pixel's path, for compare"},
                   {.name = "keep-exposures",
                    .value = "FOLDER",
                    TEXT_IN(struct render_options, keep_exposures),
                    .role = ROLE_EXPOSURES,
                    .allowed = "a folder's name",
                    .help = "write the eight 8-colour pictures of --colour exposures too"})};

const struct command command_render = {
    .name = "render",
    COMMAND_OPERANDS("SCENE", 1, 1, OPERANDS_SCENES),
    .summary = "Render a scene through firmware, ports and board to a picture.",
    .size = sizeof(struct render_options),
    .groups = OPTION_GROUPS(&group_picture, &group_statistics, &group_recording, &group_own,
                            &group_scene, &group_arithmetic, &group_jobs, &group_quiet,
                            &group_board, &group_screen, &group_faults, &group_bus),
    .examples = COMMAND_EXAMPLES("render fig3 --depth 4 -o four.png",
                                 "render my.scene --error 1 --arith f64 --jobs 4"),
    .default_output = default_output,
    .check = check_render,
    .run = run_render};
