/* SPDX-License-Identifier: MIT */
/* superframe boot: a PC-98 floppy image on an emulated CPU, with the emulated board on its ports.
 */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/output.h"
#include "base/stopwatch.h"
#include "board/equip_chain.h"
#include "board/port_chain.h"
#include "board/screen_file.h"
#include "boot/cpu.h"
#include "command/command.h"
#include "cost_bus.h"
#include "stats/run.h"
#include "trace/file.h"

/* One run of the command. */
struct boot_run {
    const struct options *options;
    const char *path;
    struct timespec began;
    uint8_t *disk;
    struct port_chain *chain;
    struct processor_report report;
    struct output picture, trace, stats;
};

/* Reads the whole image, which must have the size of a 2HD disk. */
static int read_disk(struct boot_run *run) {
    FILE *file = fopen(run->path, "rb");
    if (file == NULL) {
        return bad_input("%s: cannot be read: %s", run->path, strerror(errno));
    }
    run->disk = malloc(PC98_DISK_BYTES + 1);
    if (run->disk == NULL) {
        (void)fclose(file);
        complain("out of memory");
        return STATUS_FAILED;
    }
    errno = 0;
    size_t bytes = fread(run->disk, 1, PC98_DISK_BYTES + 1, file);
    int reason = ferror(file) ? errno : 0;
    (void)fclose(file);
    if (reason != 0) {
        return bad_input("%s: cannot be read: %s", run->path, strerror(reason));
    }
    if (bytes != PC98_DISK_BYTES) {
        return bad_input(
            "%s: no 2HD image: %s than %d bytes; allowed is a raw image of just so many", run->path,
            bytes < PC98_DISK_BYTES ? "less" : "more", PC98_DISK_BYTES);
    }
    return STATUS_DONE;
}

static int prepare(struct boot_run *run) {
    const struct options *options = run->options;
    struct board_desc desc = board_default_desc(options->profile);
    desc.base = options->base;
    int status = read_disk(run);
    if (status != STATUS_DONE) {
        return status;
    }
    run->chain = port_chain_new(&desc, true);
    if (run->chain == NULL) {
        complain("out of memory");
        return STATUS_FAILED;
    }
    status = equip_chain(run->chain, &options->board, options->stats != NULL);
    if (status != STATUS_DONE) {
        return status;
    }
    if ((options->output != NULL && !output_open(&run->picture, options->output)) ||
        (options->trace != NULL && !output_open(&run->trace, options->trace)) ||
        (options->stats != NULL && !output_open(&run->stats, options->stats))) {
        return STATUS_FAILED;
    }
    if (options->trace != NULL) {
        port_chain_record(run->chain, run->trace.file, trace_file_format(options->trace));
    }
    return STATUS_DONE;
}

/* By enum processor_register. */
static const char *const register_names[PROCESSOR_REGISTERS] = {
    "eax", "ebx",    "ecx", "edx", "esi", "edi", "ebp", "esp",
    "eip", "eflags", "cs",  "ds",  "es",  "fs",  "gs",  "ss"};

/* Tells where a run went wrong: the reason, the address, all registers. */
static void dump_registers(const struct boot_run *run) {
    const struct processor_report *report = &run->report;
    complain("%s: %s; at %08" PRIX32 "h in %s mode, after %" PRIu64 " instructions", run->path,
             report->reason, report->address, report->is_protected ? "protected" : "real",
             report->instructions);
    for (int i = 0; i < PROCESSOR_REGISTERS; i++) {
        (void)fprintf(stderr, "  %-6s %08" PRIX32 "%s", register_names[i], report->registers[i],
                      i % 4 == 3 ? "\n" : "");
    }
}

static void print_text_screen(const struct processor_report *report) {
    for (int row = 0; row < PC98_TEXT_ROWS; row++) {
        if (report->text.row[row][0] != '\0') {
            (void)fprintf(stderr, "screen: %s\n", report->text.row[row]);
        }
    }
}

static int boot(struct boot_run *run) {
    const struct processor_job job = {.disk = run->disk,
                                      .bus = &run->chain->hash.bus,
                                      .instructions_most = run->options->instructions_most,
                                      .escape_after = run->options->escape_after,
                                      .stop = interrupt_noted()};
    interrupt_catch();
    processor_run(&job, &run->report);
    if (!run->options->quiet) {
        print_text_screen(&run->report);
    }
    switch (run->report.end) {
    case PROCESSOR_HALTED:
    case PROCESSOR_STOPPED:
        return STATUS_DONE;
    case PROCESSOR_UNAVAILABLE:
    case PROCESSOR_BUS_FAILED:
        complain("%s", run->report.reason);
        return STATUS_FAILED;
    default:
        dump_registers(run);
        return STATUS_FAILED;
    }
}

static int write_results(struct boot_run *run) {
    const struct options *options = run->options;
    enum bus_status bus = port_chain_finish(run->chain);
    if (bus != BUS_OK) {
        complain("the ports: %s", bus_status_text(bus));
        return STATUS_FAILED;
    }
    if (run->trace.file != NULL && !output_commit(&run->trace)) {
        return STATUS_FAILED;
    }
    if (run->picture.file != NULL &&
        !board_picture_write(&run->picture, &run->chain->board,
                             run->chain->has_native ? &run->chain->native : NULL,
                             options->board.picture)) {
        return STATUS_FAILED;
    }
    if (run->stats.file != NULL) {
        const struct run_stats stats = {.chain = run->chain,
                                        .board = &options->board,
                                        .processor = &run->report,
                                        .total_seconds = stopwatch_seconds(&run->began)};
        stats_write(run->stats.file, &stats);
        if (!output_commit(&run->stats)) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

/* Returns the exit status of a finished run: whether it was interrupted, and whether --strict
 * holds. */
static int judge(const struct boot_run *run) {
    const struct options *options = run->options;
    if (run->report.end == PROCESSOR_STOPPED) {
        complain("interrupted after %" PRIu64 " instructions", run->report.instructions);
        return STATUS_SIGNAL + *interrupt_noted();
    }
    if (options->strict &&
        !port_chain_holds(run->chain, options->has_strict_grade, options->strict_grade)) {
        return STATUS_NOT_HELD;
    }
    return STATUS_DONE;
}

int run_boot(const struct options *options) {
    struct boot_run run;
    memset(&run, 0, sizeof run);
    run.options = options;
    run.path = options->operands[0];
    run.began = stopwatch_start();
    int status = prepare(&run);
    if (status == STATUS_DONE) {
        status = boot(&run);
    }
    if (status == STATUS_DONE) {
        status = write_results(&run);
    }
    if (status == STATUS_DONE) {
        status = judge(&run);
    }
    output_discard(&run.picture);
    output_discard(&run.trace);
    output_discard(&run.stats);
    port_chain_free(run.chain);
    free(run.disk);
    return status;
}
