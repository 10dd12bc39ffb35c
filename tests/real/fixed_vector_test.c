/* SPDX-License-Identifier: MIT */
/* fx for the vectors of hosts gives the bits that fx gives. */

/* It names its arithmetic itself, whatever the include path says. */
#include "real/fx_vector/real.h"

#include "fixed_variant.h"

int main(void) {
    return run_fixed_variant();
}
