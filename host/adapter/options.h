/* SPDX-License-Identifier: MIT */
/* Holds what the command line says of adapters. */
#ifndef SUPERFRAME_ADAPTER_OPTIONS_H
#define SUPERFRAME_ADAPTER_OPTIONS_H

#include <stdbool.h>

struct adapter_options {
    const char *serial;      /* of --bus usb:SERIAL; NULL: not said */
    bool waits;              /* --wait */
    unsigned verify_percent; /* of the lines; 0: no --verify */
};

#endif
