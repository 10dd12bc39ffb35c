/* SPDX-License-Identifier: MIT */
/* Where the port accesses of a render go: the emulated board, a trace, real ports, a cable. */
#include "options/bus.h"

#include <string.h>

#include "base/numbers.h"

/* Tells whether value is the word alone or "word:..." */
static bool is_kind(const char *value, const char *word) {
    size_t length = strlen(word);
    return strncmp(value, word, length) == 0 && (value[length] == '\0' || value[length] == ':');
}

static enum value_verdict set_bus(struct options *options, const char *value) {
    static const char trace[] = "trace:";
    if (is_kind(value, "usb") || is_kind(value, "hid")) {
        options->bus.choice = is_kind(value, "usb") ? BUS_CHOICE_USB : BUS_CHOICE_HID;
        options->bus.adapter.serial = value[3] == ':' ? value + 4 : NULL;
        return option_verdict(value[3] == '\0' || value[4] != '\0');
    }
    if (strcmp(value, "ports") == 0) {
        options->bus.choice = BUS_CHOICE_PORTS;
        return VALUE_TAKEN;
    }
    if (strncmp(value, trace, sizeof trace - 1) == 0) {
        options->bus.choice = BUS_CHOICE_TRACE;
        options->bus.file = value + sizeof trace - 1;
        return option_verdict(options->bus.file[0] != '\0');
    }
    options->bus.choice = BUS_CHOICE_EMULATOR;
    return option_verdict(strcmp(value, "emulator") == 0);
}

static enum value_verdict set_verify(struct options *options, const char *value) {
    uint64_t percent = 100;
    if (value != NULL && !value_whole(value, 1, 100, &percent)) {
        return VALUE_WRONG;
    }
    options->bus.adapter.verify_percent = (unsigned)percent;
    return VALUE_TAKEN;
}

const struct option_group group_bus = {
    "Bus",
    OPTION_ENTRIES(
        {.name = "bus",
         .value = "BUS",
         .type = OPTION_OWN,
         .set = set_bus,
         OPTION_MEMBER_OF(struct options, bus.file),
         .role = ROLE_RESULT,
         .shown = "--bus trace",
         .allowed = "emulator, trace:FILE, usb[:SERIAL], hid[:SERIAL] or ports",
         .preset = "emulator",
         .help = "where the port accesses go"},
        {.name = "verify",
         .value = "[=PERCENT]",
         .type = OPTION_OWN,
         .set = set_verify,
         .allowed = "a whole number 1..100",
         .help =
             "read back what was drawn over USB or HID, or so many of its lines, and repair it"},
        {.name = "wait",
         FLAG_IN(struct options, bus.adapter.waits),
         .help = "wait for an adapter, and for a lost one"},
        {.name = "yes-these-ports-are-mine",
         FLAG_IN(struct options, bus.ports_are_mine),
         .help = "let --bus ports open them: on a PC they belong to the DMA controller"})};

/* Names an option that goes with the emulated board only; NULL: none was given. */
static const char *board_option(const struct options *options, bool is_far) {
    return options->board.native != NULL                   ? "--native"
           : options->board.picture != PICTURE_KIND_SCREEN ? "--picture"
           : options->board.has_faults                     ? "--faults"
           : is_far && options->output != NULL             ? "--output"
           : is_far && options->board.strict               ? "--strict"
                                                           : NULL;
}

/* Checks what a trace, which has no board behind it, excludes. */
static bool check_trace_bus(const struct options *options, struct options_error *error) {
    const char *with = options->output != NULL  ? "--output"
                       : options->trace != NULL ? "--trace"
                       : options->board.strict  ? "--strict"
                                                : NULL;
    return options->bus.choice != BUS_CHOICE_TRACE || with == NULL ||
           options_refuse(error, "%s goes with --bus emulator only; a trace has no board behind it",
                          with);
}

bool bus_check(const struct options *options, struct options_error *error) {
    bool is_ports = options->bus.choice == BUS_CHOICE_PORTS;
    bool is_cable = options->bus.choice == BUS_CHOICE_USB || options->bus.choice == BUS_CHOICE_HID;
    const char *with = board_option(options, is_ports || is_cable);
    if (!check_trace_bus(options, error)) {
        return false;
    }
    if (options->bus.choice != BUS_CHOICE_EMULATOR && with != NULL) {
        return options_refuse(error, "%s goes with --bus emulator only", with);
    }
    if (is_ports && !options->bus.ports_are_mine) {
        return options_refuse(error,
                              "--bus ports: on a PC these ports are the second DMA controller's; "
                              "where they are the board's, say --yes-these-ports-are-mine");
    }
    if (!is_ports && options->bus.ports_are_mine) {
        return options_refuse(error, "--yes-these-ports-are-mine goes with --bus ports only");
    }
    if (!is_cable && (options->bus.adapter.waits || options->bus.adapter.verify_percent > 0)) {
        return options_refuse(error, "--%s goes with --bus usb and --bus hid only",
                              options->bus.adapter.waits ? "wait" : "verify");
    }
    return true;
}
