/* SPDX-License-Identifier: MIT */
/* superframe boot: a PC-98 floppy image on an emulated CPU, with the emulated board on its ports.
 */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "board/session.h"
#include "boot/cpu.h"
#include "boot/disk_image.h"
#include "command/command.h"
#include "stats/run.h"

/* Holds the options that `boot` alone takes. */
struct boot_options {
    struct options common;
    uint64_t instructions_most; /* that the CPU may run */
    uint64_t escape_after;      /* Esc when the keyboard has been asked so many times; 0: never */
    uint64_t trace_accesses;    /* that the trace may have */
    const char *screen;         /* the file of the text screen; NULL: none */
};

/* One run of the command. */
struct boot_run {
    const struct boot_options *options;
    struct session session;
    struct pc98_disk *disk;
    struct processor_report report;
    struct output screen; /* not open: not asked for */
};

/* Reads the file's bytes, as many as tell what it is. Returns false with errno set on failure. A
 * file that may not be written is a disk whose tab is set. */
static bool read_file(const char *path, uint8_t *bytes, size_t *count, bool *is_protected) {
    struct stat facts;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return false;
    }
    errno = 0;
    *count = fread(bytes, 1, DISK_IMAGE_BYTES_MOST, file);
    int reason = ferror(file) ? errno : 0;
    *is_protected =
        fstat(fileno(file), &facts) == 0 && (facts.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
    (void)fclose(file);
    errno = reason;
    return reason == 0;
}

static int read_disk(struct boot_run *run) {
    const char *path = run->options->common.operands[0];
    char reason[240];
    size_t count = 0;
    bool is_protected = false, is_read = false;
    uint8_t *bytes = malloc(DISK_IMAGE_BYTES_MOST);
    run->disk = calloc(1, sizeof *run->disk);
    if (bytes == NULL || run->disk == NULL) {
        free(bytes);
        return failure("out of memory");
    }
    if (read_file(path, bytes, &count, &is_protected)) {
        is_read = disk_image_read(bytes, count, run->disk, reason, sizeof reason);
    } else {
        (void)snprintf(reason, sizeof reason, "cannot be read: %s", strerror(errno));
    }
    run->disk->is_protected = run->disk->is_protected || is_protected;
    free(bytes);
    return is_read ? STATUS_DONE : bad_input("%s: %s", path, reason);
}

static int prepare(struct boot_run *run) {
    const struct options *options = &run->options->common;
    const struct session_files files = {options->output, options->trace, options->stats};
    int status = read_disk(run);
    if (status == STATUS_DONE) {
        status = session_begin(&run->session, &options->board, NULL);
    }
    status = status == STATUS_DONE ? session_open(&run->session, &files) : status;
    if (status != STATUS_DONE) {
        return status;
    }
    session_limit_trace(&run->session, run->options->trace_accesses);
    return run->options->screen == NULL || output_open(&run->screen, run->options->screen)
               ? STATUS_DONE
               : STATUS_FAILED;
}

/* By enum processor_register. */
static const char *const register_names[PROCESSOR_REGISTERS] = {
    "eax", "ebx",    "ecx", "edx", "esi", "edi", "ebp", "esp",
    "eip", "eflags", "cs",  "ds",  "es",  "fs",  "gs",  "ss"};

/* Tells where a run went wrong: the reason, the address, all registers. */
static void dump_registers(const struct boot_run *run) {
    const struct processor_report *report = &run->report;
    complain("%s: %s; at %08" PRIX32 "h in %s mode, after %" PRIu64 " instructions",
             run->options->common.operands[0], report->reason, report->address,
             report->is_protected ? "protected" : "real", report->instructions);
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
                                      .bus = session_bus(&run->session),
                                      .instructions_most = run->options->instructions_most,
                                      .escape_after = run->options->escape_after,
                                      .stop = interrupt_noted()};
    const char *path = run->options->common.operands[0];
    interrupt_catch();
    processor_run(&job, &run->report);
    if (!run->options->common.quiet) {
        print_text_screen(&run->report);
    }
    switch (run->report.end) {
    case PROCESSOR_WAITING:
        if (!run->options->common.quiet) {
            complain("%s: waits for a key; --escape presses one", path);
        }
        return STATUS_DONE;
    case PROCESSOR_HALTED:
    case PROCESSOR_STOPPED:
        return STATUS_DONE;
    case PROCESSOR_UNAVAILABLE:
    case PROCESSOR_BUS_FAILED:
        return failure("%s", run->report.reason);
    case PROCESSOR_LOST:
    case PROCESSOR_RESET:
    case PROCESSOR_LIMIT:
        break;
    }
    dump_registers(run);
    return STATUS_FAILED;
}

static int write_results(struct boot_run *run) {
    const struct run_stats stats = {.session = &run->session, .processor = &run->report};
    int status = session_end_accesses(&run->session);
    if (status == STATUS_DONE && run->screen.file != NULL) {
        errno = 0;
        status = output_finish(&run->screen, pc98_text_write(run->screen.file, &run->report.text));
    }
    if (status == STATUS_DONE && !(session_commit_picture(&run->session) && stats_commit(&stats))) {
        status = STATUS_FAILED;
    }
    return status;
}

/* Returns the exit status of a finished run: whether it was interrupted, and whether --strict
 * holds. */
static int judge(struct boot_run *run) {
    if (run->report.end == PROCESSOR_STOPPED) {
        complain("interrupted after %" PRIu64 " instructions", run->report.instructions);
        return STATUS_SIGNAL + *interrupt_noted();
    }
    return session_judge(&run->session);
}

static int run_boot(const struct options *options) {
    static int (*const steps[])(struct boot_run *) = {prepare, boot, write_results, judge};
    struct boot_run run;
    memset(&run, 0, sizeof run);
    run.options = (const struct boot_options *)options;
    run.session.began = stopwatch_start();
    int status = STATUS_DONE;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0] && status == STATUS_DONE; i++) {
        status = steps[i](&run);
    }
    session_free(&run.session);
    output_discard(&run.screen);
    free(run.disk);
    return status;
}

static const char *const cpus[] = {"386", NULL};
static const struct option_group group_own = {
    "CPU", OPTION_ENTRIES(
               {.name = "cpu",
                .value = "CPU",
                .type = OPTION_WORD,
                .words = cpus,
                .preset = "386",
                .help = "the CPU that runs the image"},
               {.name = "instructions",
                .value = "N",
                WHOLE_IN(struct boot_options, instructions_most, 1, 1e15),
                .preset = "200000000000", /* a frame of 640 x 400 takes some 60 thousand million */
                .help = "end as failed after so many"},
               {.name = "escape",
                .value = "N",
                WHOLE_IN(struct boot_options, escape_after, 1, 1e15),
                .help = "press Esc when the keyboard has been asked N times"},
               {.name = "trace-accesses",
                .value = "N",
                WHOLE_IN(struct boot_options, trace_accesses, 1, 1e15),
                .preset = "20000000", /* some twenty pictures of 640 x 400 */
                .help = "end the trace after so many accesses"},
               {.name = "screen",
                .value = "FILE",
                TEXT_IN(struct boot_options, screen),
                .role = ROLE_RESULT,
                .allowed = "a file's name or -",
                .help = "write the text screen, with its colours, as text"})};

const struct command command_boot = {
    .name = "boot",
    COMMAND_OPERANDS("IMAGE", 1, 1, OPERANDS_FILES),
    .summary = "Run a PC-98 floppy image on an emulated CPU.",
    .size = sizeof(struct boot_options),
    .groups = OPTION_GROUPS(&group_picture, &group_statistics, &group_recording, &group_own,
                            &group_quiet, &group_board, &group_screen, &group_faults),
    .examples = COMMAND_EXAMPLES("boot fig3.hdm -o screen.png",
                                 "boot probe.hdm --escape 100 --instructions 1000000000"),
    .run = run_boot};
