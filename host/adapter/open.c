/* SPDX-License-Identifier: MIT */
/* The adapter at the end of a cable, for the sub-commands that draw on it. */
#include "adapter/open.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "adapter/drivers.h"
#include "base/complain.h"
#include "base/interrupt.h"

enum {
    WAIT_POLL_MS = 100,
    WAIT_REOPEN_MS = 60000, /* for a replug in the middle, with --wait */
    WAIT_SETTLE_MS = 3000, /* with --wait: for udev to let us in to an adapter that has just come */
    RANGES_SIZE = 256
};

static void pause_ms(long milliseconds) {
    const struct timespec pause = {milliseconds / 1000, milliseconds % 1000 * 1000000L};
    (void)nanosleep(&pause, NULL);
}

/* Returns a seed that differs in each run: a session's number must not be known to an adapter
 * already. */
static uint64_t session_seed(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_REALTIME, &now);
    return (uint64_t)now.tv_sec << 30 ^ (uint64_t)now.tv_nsec ^ (uint64_t)getpid() << 40;
}

static int open_backend(struct adapter_bus *adapter, const struct adapter_options *options) {
    char reason[USB_LINK_REASON_SIZE] = "";
    const struct usb_backend *backend = usb_backend_find(adapter->name, reason);
    enum usb_open_status status =
        backend != NULL ? backend->open(options->serial, &adapter->link, reason) : USB_OPEN_REFUSED;
    if (status == USB_OPEN_ABSENT && options->waits) {
        complain("--bus %s: waiting for an adapter%s%s", adapter->name,
                 options->serial != NULL ? " " : "",
                 options->serial != NULL ? options->serial : "");
    }
    for (unsigned denied_ms = 0;
         options->waits && (status == USB_OPEN_ABSENT ||
                            (status == USB_OPEN_DENIED && denied_ms < WAIT_SETTLE_MS));) {
        denied_ms += status == USB_OPEN_DENIED ? WAIT_POLL_MS : 0;
        if (*interrupt_noted() != 0) {
            complain("interrupted before an adapter came");
            return STATUS_SIGNAL + *interrupt_noted();
        }
        pause_ms(WAIT_POLL_MS);
        status = backend->open(options->serial, &adapter->link, reason);
    }
    if (status != USB_OPEN_OK) {
        return failure("--bus %s: %s; nothing was drawn", adapter->name, reason);
    }
    return STATUS_DONE;
}

int adapter_bus_open(struct adapter_bus *adapter, const char *name, uint16_t base,
                     const struct adapter_options *options) {
    struct usb_limits limits = usb_default_limits();
    limits.seed = session_seed();
    limits.stop = interrupt_noted();
    if (options->waits) {
        limits.reopen_ms = WAIT_REOPEN_MS;
    }
    memset(adapter, 0, sizeof *adapter);
    adapter->name = name;
    interrupt_catch();
    int status = open_backend(adapter, options);
    if (status != STATUS_DONE) {
        return status;
    }
    adapter->usb = usb_bus_new(adapter->link, base, &limits);
    if (adapter->usb == NULL) {
        return failure("out of memory");
    }
    if (adapter->usb->bus.status != BUS_OK) {
        return failure("--bus %s: %s; nothing was drawn", adapter->name, adapter->usb->reason);
    }
    return STATUS_DONE;
}

int adapter_bus_verify(struct adapter_bus *adapter, unsigned percent, uint64_t seed) {
    struct usb_verification *found = &adapter->verification;
    if (!usb_bus_verify(adapter->usb, percent, seed, found)) {
        return failure("--verify: given up after %" PRIu64 " pixels", found->pixels);
    }
    adapter->is_verified = true;
    if (found->wrong_lines > 0) {
        return failure(
            "--verify: %u lines of the board still differ after %u repairs, the first is %u; "
            "%" PRIu64 " pixels were repaired",
            found->wrong_lines, (unsigned)USB_REPAIRS_MOST, found->first_wrong, found->repaired);
    }
    complain("--verify: %" PRIu64 " pixels read back, %" PRIu64 " differed and were repaired",
             found->pixels, found->repaired);
    return STATUS_DONE;
}

void adapter_bus_write_stats(const struct adapter_bus *adapter, struct json *json) {
    const struct usb_counts *counts = &adapter->usb->counts;
    json_begin_object(json, "adapter");
    json_text(json, "bus", adapter->name);
    json_count(json, "bytes_out", counts->sent_bytes);
    json_count(json, "bytes_in", counts->received_bytes);
    json_count(json, "transfers", adapter->link->transfers);
    json_count(json, "frames", counts->frames);
    json_count(json, "resent", counts->resent);
    json_count(json, "timeouts", counts->timeouts);
    json_count(json, "stalls", counts->stalls);
    json_count(json, "reconnects", counts->reconnects);
    json_count(json, "restarts", counts->restarts);
    if (adapter->is_verified) {
        json_count(json, "verified_pixels", adapter->verification.pixels);
        json_count(json, "repaired_pixels", adapter->verification.repaired);
    } else {
        json_text(json, "verified_pixels", NULL);
        json_text(json, "repaired_pixels", NULL);
    }
    json_end_object(json);
}

static bool is_row_there(const struct usb_bus *usb, unsigned row, unsigned lines) {
    bool is_there = true;
    for (unsigned line = row * lines; line < (row + 1) * lines && line < BOARD_HEIGHT; line++) {
        is_there = is_there && usb_bus_line_is_there(usb, line);
    }
    return is_there;
}

/* Prints the rows that are there, or those that are not, as "0-57, 60"; returns how many. */
static unsigned print_rows(const struct usb_bus *usb, const unsigned rows[2], unsigned lines,
                           bool is_there, char *text) {
    unsigned count = 0;
    int used = 0;
    text[0] = '\0';
    for (unsigned row = rows[0]; row < rows[1]; row++) {
        unsigned begin = row;
        while (row < rows[1] && is_row_there(usb, row, lines) == is_there) {
            row++;
        }
        if (row > begin) {
            count += row - begin;
            if (used > RANGES_SIZE - 32) {
                (void)snprintf(text + used, (size_t)(RANGES_SIZE - used), ", and more");
                continue;
            }
            used += snprintf(text + used, (size_t)(RANGES_SIZE - used),
                             row - begin == 1 ? "%s%u" : "%s%u-%u", used > 0 ? ", " : "", begin,
                             row - 1);
        }
    }
    return count;
}

void adapter_bus_explain(const struct adapter_bus *adapter, unsigned first, unsigned last,
                         unsigned lines) {
    const unsigned rows[2] = {first, last};
    char there[RANGES_SIZE], missing[RANGES_SIZE];
    unsigned count = print_rows(adapter->usb, rows, lines, true, there);
    (void)print_rows(adapter->usb, rows, lines, false, missing);
    complain("--bus %s: %s; of %u rows %u are known to be on the board%s%s; missing are %s",
             adapter->name,
             adapter->usb->reason[0] != '\0' ? adapter->usb->reason
                                             : bus_status_text(adapter->usb->bus.status),
             last - first, count, count > 0 ? ": " : "", there,
             missing[0] != '\0' ? missing : "none");
}

void adapter_bus_close(struct adapter_bus *adapter) {
    usb_bus_free(adapter->usb);
    if (adapter->link != NULL) {
        adapter->link->operations->close(adapter->link);
    }
    adapter->usb = NULL;
    adapter->link = NULL;
}
