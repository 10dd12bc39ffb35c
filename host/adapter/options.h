/* SPDX-License-Identifier: MIT */
/* What the command line says of adapters, real and virtual. */
#ifndef SUPERFRAME_ADAPTER_OPTIONS_H
#define SUPERFRAME_ADAPTER_OPTIONS_H

#include <stdbool.h>

struct adapter_options {
    const char *serial; /* of --bus usb:SERIAL, and the virtual adapter's own; NULL: not said */
    bool waits;         /* --wait */
    unsigned verify_percent; /* of the lines; 0: no --verify */
    const char *listen;      /* ADDRESS or ADDRESS:PORT; NULL: 127.0.0.1:3240 */
    bool once;               /* the virtual adapter ends when its first client leaves */
};

#endif
