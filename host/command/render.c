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

/* One run of the command. What it holds is freed whatever happens. */
struct render_run {
    const struct options *options;
    const char *scene_name;
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
    if (options->bus != BUS_CHOICE_EMULATOR) {
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
        .trace = options->bus == BUS_CHOICE_TRACE ? options->bus_file : options->trace,
        .stats = options->stats};
    int status = session_open(&run->session, &files);
    if (status == STATUS_DONE && options->signatures != NULL &&
        !output_open(&run->signatures, options->signatures)) {
        status = STATUS_FAILED;
    }
    return status;
}

static int open_camera(struct render_run *run) {
    const char *folder = run->options->keep_exposures;
    if (run->compiled->show != SHOW_EXPOSURES) {
        return folder == NULL ? STATUS_DONE
                              : bad_input("--keep-exposures goes with --colour exposures only");
    }
    if (run->options->bus == BUS_CHOICE_EMULATOR) {
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
    complain("--bus ports: %s", message);
    return STATUS_FAILED;
}

static int load(struct render_run *run) {
    const struct options *options = run->options;
    struct scene_error error;
    run->compiled = load_compiled_scene(run->scene_name, &options->overrides, &error);
    if (run->compiled == NULL) {
        return bad_input("%s", error.text);
    }
    if (options->has_rows && options->last_row > run->compiled->height) {
        return bad_input("--rows %u:%u: the picture has %u rows; allowed is: up to 0:%u",
                         options->first_row, options->last_row, run->compiled->height,
                         run->compiled->height);
    }
    return STATUS_DONE;
}

/* Prints which rows are on the board behind the adapter, after a failure. */
static void explain_adapter(const void *context) {
    const struct render_run *run = context;
    const struct compiled_scene *compiled = run->compiled;
    adapter_bus_explain(&run->adapter, run->options->has_rows ? run->options->first_row : 0,
                        run->options->has_rows ? run->options->last_row : compiled->height,
                        render_dots(compiled->width, compiled->height));
}

/* Begins the session with what --bus asks for at the end of the buses. */
static int begin_session(struct render_run *run) {
    const struct options *options = run->options;
    struct session_device device = {NULL, NULL, NULL};
    int status = STATUS_DONE;
    switch (options->bus) {
    case BUS_CHOICE_EMULATOR:
        return session_begin(&run->session, &options->board, NULL);
    case BUS_CHOICE_TRACE:
        break;
    case BUS_CHOICE_PORTS:
        device.bus = &run->ports.bus;
        break;
    case BUS_CHOICE_USB:
    case BUS_CHOICE_HID:
        status = adapter_bus_open(&run->adapter, options->bus == BUS_CHOICE_HID ? "hid" : "usb",
                                  options->board.base, &options->adapter);
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
    int status = options->bus == BUS_CHOICE_PORTS ? open_own_ports(&run->ports, options->board.base)
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
    job.first_row = options->has_rows ? options->first_row : 0;
    job.last_row = options->has_rows ? options->last_row : run->compiled->height;
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
    const unsigned percent = run->options->adapter.verify_percent;
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
                                    .scene = run->scene_name,
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
    const unsigned first = run->options->has_rows ? run->options->first_row : 0;
    const struct signature_job job = {.arithmetic = arithmetic_find(run->options->arithmetic),
                                      .scene = run->compiled,
                                      .first_row = first,
                                      .last_row = first + run->totals.rows,
                                      .jobs = run->options->jobs,
                                      .stop = interrupt_noted()};
    memset(&signatures, 0, sizeof signatures);
    if (!signatures_make(&job, &signatures, &error)) {
        return bad_input("%s", error.text);
    }
    errno = 0;
    bool is_written = signatures_write(&signatures, run->signatures.file);
    if (!is_written) {
        output_complain(&run->signatures, strerror(errno));
    }
    signatures_free(&signatures);
    return is_written && output_commit(&run->signatures) ? STATUS_DONE : STATUS_FAILED;
}

/* Says on a terminal where the picture is. */
static void tell_place(const struct render_run *run) {
    const char *name = run->session.files.picture;
    if (name != NULL && strcmp(name, "-") != 0 && !run->options->quiet &&
        isatty(STDERR_FILENO) == 1) {
        (void)fprintf(stderr, "The picture is %s\n", name);
    }
}

/* Returns the exit status of a finished run: whether it was interrupted, and whether --strict
 * holds. */
static int judge(const struct render_run *run) {
    if (*interrupt_noted() != 0) {
        const char *partial = run->session.partial_name;
        complain("interrupted after %u rows%s%s", run->totals.rows,
                 partial != NULL ? "; what was drawn is in " : "", partial != NULL ? partial : "");
        return STATUS_SIGNAL + *interrupt_noted();
    }
    tell_place(run);
    return session_judge(&run->session);
}

static int run_render(const struct options *options) {
    struct render_run run;
    memset(&run, 0, sizeof run);
    run.options = options;
    run.scene_name = options->operands[0];
    run.session.began = stopwatch_start();
    int status = prepare(&run);
    if (status == STATUS_DONE) {
        status = render_rows(&run);
    }
    if (status == STATUS_DONE) {
        status = write_results(&run);
    }
    if (status == STATUS_DONE && run.signatures.file != NULL) {
        status = write_signatures(&run);
    }
    if (status == STATUS_DONE) {
        status = judge(&run);
    }
    output_discard(&run.signatures);
    camera_free(run.camera);
    session_free(&run.session);
    adapter_bus_close(&run.adapter);
    free(run.compiled);
    return status;
}

/* ---- The command ---------------------------------------------------------------------------- */

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

static const struct option_entry own_entries[] = {
    {.name = "rows",
     .value = "A:B",
     .type = OPTION_OWN,
     .set = set_rows,
     .allowed = "A:B with 0 <= A < B <= 400",
     .help = "only rows A..B-1; the others are not touched"},
    {.name = "keep-exposures",
     .value = "FOLDER",
     .type = OPTION_TEXT,
     OPTION_MEMBER(keep_exposures),
     .role = ROLE_EXPOSURES,
     .allowed = "a folder's name",
     .help = "write the eight 8-colour pictures of --colour exposures too"},
    {.name = "signatures",
     .value = "FILE",
     .type = OPTION_TEXT,
     OPTION_MEMBER(signatures),
     .role = ROLE_RESULT,
     .help = "write a hash of each pixel's path, for compare"},
    {.name = NULL}};
static const struct option_group group_own = {"Result", own_entries};

static const struct option_group *const groups[] = {&group_picture,
                                                    &group_statistics,
                                                    &group_recording,
                                                    &group_own,
                                                    &group_scene,
                                                    &group_arithmetic,
                                                    &group_jobs,
                                                    &group_quiet,
                                                    &group_board,
                                                    &group_screen,
                                                    &group_faults,
                                                    &group_bus,
                                                    NULL};
static const char *const examples[] = {"render fig3 --depth 4 -o four.png",
                                       "render my.scene --error 1 --arith f64 --jobs 4", NULL};

const struct command command_render = {
    .name = "render",
    .operands = "SCENE",
    .summary = "Render a scene through firmware, ports and board to a picture.",
    .least = 1,
    .most = 1,
    .kind = OPERANDS_SCENES,
    .groups = groups,
    .examples = examples,
    .default_output = default_output,
    .check = bus_check,
    .run = run_render};
