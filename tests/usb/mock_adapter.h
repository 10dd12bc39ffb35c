/* SPDX-License-Identifier: MIT */
/* An adapter that the real libusb, hidapi and libudev see: its nodes and sysfs are umockdev's, its
 * answers are the device logic's, with a board behind it. */
#ifndef SUPERFRAME_TESTS_USB_MOCK_ADAPTER_H
#define SUPERFRAME_TESTS_USB_MOCK_ADAPTER_H

#include <stdbool.h>
#include <stdint.h>

#include "board.h"
#include "usb_device.h"

/* What goes wrong, each so many times from now on; all zero: nothing. */
struct mock_faults {
    unsigned stalls;          /* transfers to the device that are refused */
    unsigned lost_replies;    /* transfers from the device that come to nothing */
    unsigned corrupt_replies; /* with a flipped bit */
    unsigned double_replies;  /* that come twice */
    bool is_mute;             /* says nothing at all */
    bool is_short;            /* a bulk read gives 7 bytes at most */
    unsigned unplug_after;    /* transfers to the device; 0: never */
    bool is_lost_for_good;    /* it is not plugged in again */
    bool forgets;             /* it was switched off before it is plugged in again */
};

/* True if the process runs under umockdev's preloaded library; else it starts itself again so, and
 * does not return. */
bool mock_enter(char **argv);

/* Plugs the adapter in, freshly powered on. */
void mock_plug(const struct mock_faults *faults);

/* Sets what goes wrong from now on. */
void mock_set_faults(const struct mock_faults *faults);

/* Pulls it out for good, and forgets everything. */
void mock_remove(void);

/* The board behind it: not to be looked at while transfers are on their way. */
const struct board *mock_board(void);

/* What the adapter has counted. */
struct usb_adapter mock_state(void);

#endif
