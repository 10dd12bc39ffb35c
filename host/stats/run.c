/* SPDX-License-Identifier: MIT */
/* The statistics of a run as a JSON object. */
#include "stats/run.h"

#include <inttypes.h>
#include <stdbool.h>

#include "base/json.h"
#include "base/stopwatch.h"
#include "stats/port_cost.h"

static void write_count(FILE *out, const char *key, uint64_t count) {
    (void)fprintf(out, "  \"%s\": %" PRIu64 ",\n", key, count);
}

/* Writes what the estimates of cut branches have learned and reached. */
static void write_estimate(FILE *out, const struct run_stats *stats) {
    static const char *const names[WAYS + 1] = {
        [WAY_DOWN] = "tail_down", [WAY_UP] = "tail_up", [WAY_ANY] = "tail"};
    const struct render_totals *totals = stats->totals;
    const struct estimate_level *level = &totals->estimate.level[totals->estimate.typical];
    write_count(out, "learning_rays", totals->learning_rays);
    for (int way = 0; way <= WAYS; way++) {
        const int32_t *mean = level->mean[way];
        (void)fprintf(out, "  \"%s\": [%.6f, %.6f, %.6f],\n", names[way], mean[0] / 65536.0,
                      mean[1] / 65536.0, mean[2] / 65536.0);
    }
    if (stats->compiled->error > 0) {
        (void)fprintf(out, "  \"error\": %.17g,\n  \"spread\": %.6f,\n", stats->compiled->error,
                      level->spread / 65536.0);
        (void)fprintf(out, "  \"estimated_error\": %.6f,\n", totals->estimated_error / 65536.0);
        (void)fprintf(out, "  \"worst_pixel\": [%u, %u],\n", totals->worst_x, totals->worst_y);
        write_count(out, "proved_error", totals->proved_error);
    }
}

static void write_render(FILE *out, const struct run_stats *stats) {
    const struct compiled_scene *compiled = stats->compiled;
    const struct render_totals *totals = stats->totals;
    (void)fputs("  \"scene\": ", out);
    json_write_string(out, stats->scene);
    (void)fputs(",\n  \"arith\": ", out);
    json_write_string(out, stats->arithmetic);
    (void)fprintf(out, ",\n  \"depth\": %u,\n  \"threshold\": %.17g,\n", compiled->depth_asked,
                  compiled->threshold);
    write_count(out, "width", compiled->width);
    write_count(out, "height", compiled->height);
    write_count(out, "pixels", (uint64_t)compiled->width * totals->rows);
    write_count(out, "nodes", totals->nodes);
    write_count(out, "rays", totals->rays);
    write_count(out, "shadow_rays", totals->shadow_rays);
    write_count(out, "solid_tests", totals->solid_tests);
    write_count(out, "leaked_rays", totals->leaked_rays);
    write_count(out, "exhausted_pixels", totals->exhausted_pixels);
    if (compiled->estimates) {
        write_estimate(out, stats);
    }
}

/* Writes the instructions of an emulated CPU, and the seconds predicted for an RA2. The average of
 * 4.4 clocks an instruction on the 80386 is assumed: the mix here has more products than most. The
 * ports' own clocks are in port_cost. */
static void write_processor(FILE *out, const struct run_stats *stats) {
    const double clocks = 4.4;
    const struct cost_machine *machine = cost_machine_by_name("RA2");
    write_count(out, "instructions", stats->processor->instructions);
    (void)fprintf(out, "  \"predicted_seconds_RA2\": %.1f,\n",
                  (double)stats->processor->instructions * clocks / (machine->megahertz * 1e6));
}

static void write_cost(FILE *out, const struct run_stats *stats) {
    const struct port_chain *chain = stats->session->chain;
    const struct board_options *board = stats->session->options;
    double frames[COST_SHOWN];
    if (stats->totals == NULL) {
        stats_write_cost(out, &chain->cost, board, NULL);
        return;
    }
    stats_predict_frames(stats->compiled, stats->totals, stats->arithmetic,
                         port_chain_writes(chain), frames);
    stats_write_cost(out, &chain->cost, board, frames);
}

static void write_stats(FILE *out, const struct run_stats *stats) {
    struct port_chain *chain = stats->session->chain;
    (void)fputs("{\n", out);
    if (stats->totals != NULL) {
        write_render(out, stats);
    }
    write_count(out, "port_writes", port_chain_writes(chain));
    write_count(out, "port_reads", port_chain_reads(chain));
    if (stats->totals != NULL && stats->totals->rows > 0) {
        double pixels = (double)stats->compiled->width * stats->totals->rows;
        (void)fprintf(out, "  \"port_writes_per_pixel\": %.6f,\n",
                      (double)port_chain_writes(chain) / pixels);
    }
    (void)fprintf(out, "  \"trace_hash\": \"%016" PRIx64 "\",\n", trace_hash_value(&chain->hash));
    if (chain->has_board) {
        port_chain_picture(chain);
        (void)fprintf(out, "  \"frame_crc\": \"%08" PRIx32 "\",\n", picture_crc(chain->rgb));
        write_count(out, "violations", board_violations(&chain->board));
    } else {
        (void)fputs("  \"frame_crc\": null,\n  \"violations\": null,\n", out);
    }
    if (stats->photograph != NULL) {
        (void)fprintf(out, "  \"photograph_crc\": \"%08" PRIx32 "\",\n",
                      picture_crc(stats->photograph));
    }
    write_cost(out, stats);
    if (stats->adapter != NULL) {
        adapter_bus_write_stats(stats->adapter, out);
    }
    if (stats->processor != NULL) {
        write_processor(out, stats);
    }
    if (stats->totals != NULL && chain->first.has_happened) {
        (void)fprintf(
            out, "  \"first_write_seconds\": %.6f,\n  \"first_write_cpu_seconds\": %.6f,\n",
            stopwatch_between(&stats->session->began, &chain->first.at), chain->first.cpu_seconds);
    }
    if (stats->totals != NULL) {
        (void)fprintf(out, "  \"render_seconds\": %.6f,\n", stats->totals->seconds);
    }
    (void)fprintf(out, "  \"total_seconds\": %.6f\n}\n", stopwatch_seconds(&stats->session->began));
}

bool stats_commit(const struct run_stats *stats) {
    struct output *output = &stats->session->stats;
    if (output->file == NULL) {
        return true;
    }
    write_stats(output->file, stats);
    return output_commit(output);
}
