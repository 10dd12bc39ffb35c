/* SPDX-License-Identifier: MIT */
/* The statistics of a run as a JSON object. */
#ifndef SUPERFRAME_STATS_H
#define SUPERFRAME_STATS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "adapter/open.h"
#include "board/session.h"
#include "boot/cpu.h"
#include "render/render.h"

/* The parts of a run that the statistics tell of; NULL where there is no such part. */
struct run_stats {
    struct session *session; /* its picture is drawn if it has a board */
    const char *scene, *arithmetic;
    const struct compiled_scene *compiled;
    const struct render_totals *totals; /* of a render; NULL: a replay, which has only the ports */
    const struct processor_report
        *processor;                    /* of a run on an emulated CPU; NULL: there was none */
    const struct adapter_bus *adapter; /* at the end of a cable; NULL: there was none */
    const uint8_t *photograph; /* of a multiple exposure, PICTURE_BYTES; NULL: none was taken */
};

/* Writes the JSON object and a line's end to the session's statistics, and puts the file into its
 * place. The keys are those that superframe(1) lists. frame_crc and violations are null where no
 * board was behind the ports. True without statistics, too, if none are asked for. False, with the
 * reason printed, on failure. */
bool stats_commit(const struct run_stats *stats);

#endif
