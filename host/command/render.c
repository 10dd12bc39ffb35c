/* SPDX-License-Identifier: MIT */
/* superframe render: a scene through firmware, ports and board to a picture. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "adapter/open.h"
#include "base/interrupt.h"
#include "base/output.h"
#include "base/png_output.h"
#include "base/stopwatch.h"
#include "board/camera.h"
#include "board/equip_chain.h"
#include "board/port_chain.h"
#include "board/screen_file.h"
#include "command/command.h"
#include "render/arithmetic.h"
#include "render/progress.h"
#include "render/remarks.h"
#include "render/render.h"
#include "render/signatures.h"
#include "scene/load.h"
#include "stats/run.h"
#include "trace/file.h"

enum { NAME_SIZE = 256 };

/* One run of the command. What it holds is freed whatever happens. */
struct render_run {
    const struct options *options;
    const char *scene_name;
    struct timespec began;
    struct compiled_scene *compiled;
    struct ports_linux ports;   /* of --bus ports */
    struct adapter_bus adapter; /* of --bus usb and hid */
    struct port_chain *chain;
    struct exposures *exposures; /* NULL: the scene is not shown by exposures, or to no board */
    struct output picture, trace, stats, signatures;
    char default_name[NAME_SIZE];
    struct render_totals totals;
};

/* Returns the name of the file where the picture goes; NULL: there is no picture. */
static const char *picture_name(struct render_run *run) {
    if (run->options->bus != BUS_CHOICE_EMULATOR) {
        return NULL;
    }
    if (run->options->output != NULL) {
        return run->options->output;
    }
    scene_picture_name(run->scene_name, run->default_name, NAME_SIZE);
    return run->default_name;
}

/* Opens all results before the work begins: a name that can't be written is known at once. */
static bool open_outputs(struct render_run *run) {
    const struct options *options = run->options;
    const char *picture = picture_name(run);
    const char *trace = options->bus == BUS_CHOICE_TRACE ? options->bus_file : options->trace;
    if ((picture != NULL && !output_open(&run->picture, picture)) ||
        (options->stats != NULL && !output_open(&run->stats, options->stats)) ||
        (options->signatures != NULL && !output_open(&run->signatures, options->signatures)) ||
        (trace != NULL && !output_open(&run->trace, trace))) {
        return false;
    }
    if (trace != NULL) {
        port_chain_record(run->chain, run->trace.file, trace_file_format(trace));
    }
    return true;
}

static int open_exposures(struct render_run *run) {
    const char *folder = run->options->keep_exposures;
    if (run->compiled->show != COMPILED_EXPOSURES) {
        return folder == NULL ? STATUS_DONE
                              : bad_input("--keep-exposures goes with --colour exposures only");
    }
    if (run->options->bus == BUS_CHOICE_EMULATOR) {
        run->exposures = exposures_new(run->chain, folder);
        return run->exposures != NULL ? STATUS_DONE : STATUS_FAILED;
    }
    return STATUS_DONE;
}

static int prepare(struct render_run *run) {
    const struct options *options = run->options;
    struct scene_error error;
    int status =
        options->bus == BUS_CHOICE_PORTS ? open_own_ports(&run->ports, options->base) : STATUS_DONE;
    if (status != STATUS_DONE) {
        return status;
    }
    run->compiled = load_compiled_scene(run->scene_name, &options->overrides, &error);
    if (run->compiled == NULL) {
        return bad_input("%s", error.text);
    }
    if (options->has_rows && options->last_row > run->compiled->height) {
        return bad_input("--rows %u:%u: the picture has %u rows; allowed is: up to 0:%u",
                         options->first_row, options->last_row, run->compiled->height,
                         run->compiled->height);
    }
    struct board_desc desc = board_default_desc(options->profile);
    desc.base = options->base;
    run->chain = port_chain_new(&desc, options->bus == BUS_CHOICE_EMULATOR);
    if (run->chain == NULL) {
        complain("out of memory");
        return STATUS_FAILED;
    }
    if (options->bus == BUS_CHOICE_PORTS) {
        port_chain_end_at(run->chain, &run->ports.bus);
    }
    if (options->bus == BUS_CHOICE_USB || options->bus == BUS_CHOICE_HID) {
        status = adapter_bus_open(&run->adapter, options->bus == BUS_CHOICE_HID, options->base,
                                  &options->adapter);
        if (status != STATUS_DONE) {
            return status;
        }
        port_chain_end_at(run->chain, &run->adapter.usb->bus);
    }
    status = equip_chain(run->chain, &options->board, options->stats != NULL);
    if (status == STATUS_DONE) {
        status = open_exposures(run);
    }
    if (status != STATUS_DONE) {
        return status;
    }
    return open_outputs(run) ? STATUS_DONE : STATUS_FAILED;
}

static int render_rows(struct render_run *run) {
    const struct options *options = run->options;
    struct progress progress;
    struct scene_error error;
    struct render_job job;
    memset(&job, 0, sizeof job);
    job.arithmetic = arithmetic_find(options->arithmetic);
    job.scene = run->compiled;
    job.base = options->base;
    job.first_row = options->has_rows ? options->first_row : 0;
    job.last_row = options->has_rows ? options->last_row : run->compiled->height;
    job.jobs = options->jobs;
    job.stop = interrupt_noted();
    job.progress = progress_show;
    job.context = &progress;
    job.exposed = run->exposures != NULL ? exposures_take : NULL;
    job.exposed_context = run->exposures;
    remarks_complain(run->compiled, job.arithmetic);
    progress_begin(&progress, job.last_row - job.first_row, options->quiet);
    interrupt_catch();
    (void)bus_bind(port_chain_bus(run->chain, run->stats.file != NULL));
    bool is_rendered = render(&job, &run->totals, &error);
    progress_end(&progress);
    return is_rendered ? STATUS_DONE : bad_input("%s", error.text);
}

/* Writes the screen's picture, or the camera's where the scene is shown by exposures. */
static bool write_picture(struct render_run *run) {
    if (run->exposures == NULL) {
        return board_picture_write(&run->picture, &run->chain->board,
                                   run->chain->has_native ? &run->chain->native : NULL,
                                   run->options->board.picture);
    }
    return png_output(&run->picture, run->exposures->rgb, PICTURE_WIDTH, PICTURE_HEIGHT);
}

/* Prints which rows are on the board behind the adapter, after a failure. */
static void explain_adapter(const struct render_run *run) {
    const struct compiled_scene *compiled = run->compiled;
    adapter_bus_explain(&run->adapter, run->options->has_rows ? run->options->first_row : 0,
                        run->options->has_rows ? run->options->last_row : compiled->height,
                        render_dots(compiled->width, compiled->height));
}

/* Ends the trace, then writes the rest of what was asked for. */
static int write_results(struct render_run *run) {
    enum bus_status bus = port_chain_finish(run->chain);
    if (bus != BUS_OK) {
        if (run->trace.file != NULL && run->chain->recorder.error_number != 0) {
            output_complain(&run->trace, strerror(run->chain->recorder.error_number));
        } else if (run->adapter.usb != NULL) {
            explain_adapter(run);
        } else {
            complain("the ports: %s", bus_status_text(bus));
        }
        return STATUS_FAILED;
    }
    if (run->trace.file != NULL && !output_commit(&run->trace)) {
        return STATUS_FAILED;
    }
    if (run->options->adapter.verify_percent > 0 &&
        adapter_bus_verify(&run->adapter, run->options->adapter.verify_percent,
                           run->options->overrides.seed) != STATUS_DONE) {
        if (run->adapter.usb->bus.status != BUS_OK) {
            explain_adapter(run);
        }
        return STATUS_FAILED;
    }
    if (run->exposures != NULL) {
        exposures_develop(run->exposures);
        if (!exposures_commit(run->exposures)) {
            return STATUS_FAILED;
        }
    }
    if (run->picture.file != NULL && !write_picture(run)) {
        return STATUS_FAILED;
    }
    if (run->stats.file != NULL) {
        const struct run_stats stats = {.scene = run->scene_name,
                                        .arithmetic = run->options->arithmetic,
                                        .compiled = run->compiled,
                                        .totals = &run->totals,
                                        .chain = run->chain,
                                        .board = &run->options->board,
                                        .began = &run->began,
                                        .adapter = run->adapter.usb != NULL ? &run->adapter : NULL,
                                        .total_seconds = stopwatch_seconds(&run->began),
                                        .photograph =
                                            run->exposures != NULL ? run->exposures->rgb : NULL};
        stats_write(run->stats.file, &stats);
        if (!output_commit(&run->stats)) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
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

/* Returns the exit status of a finished run: whether it was interrupted, and whether --strict
 * holds. */
static int judge(const struct render_run *run) {
    const struct options *options = run->options;
    if (*interrupt_noted() != 0) {
        complain("interrupted after %u rows", run->totals.rows);
        return STATUS_SIGNAL + *interrupt_noted();
    }
    if (options->strict &&
        !port_chain_holds(run->chain, options->has_strict_grade, options->strict_grade)) {
        return STATUS_NOT_HELD;
    }
    return STATUS_DONE;
}

int run_render(const struct options *options) {
    struct render_run run;
    memset(&run, 0, sizeof run);
    run.options = options;
    run.scene_name = options->operands[0];
    run.began = stopwatch_start();
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
    output_discard(&run.picture);
    output_discard(&run.trace);
    output_discard(&run.stats);
    output_discard(&run.signatures);
    exposures_free(run.exposures);
    port_chain_free(run.chain);
    adapter_bus_close(&run.adapter);
    free(run.compiled);
    return status;
}
