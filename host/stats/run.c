/* SPDX-License-Identifier: MIT */
/* The statistics of a run as a JSON object. */
#include "stats/run.h"

#include "base/json.h"
#include "base/stopwatch.h"
#include "stats/port_cost.h"

enum { CRC_DIGITS = 8, HASH_DIGITS = 16 };

/* Writes what the estimates of pruned branches have learned and reached. */
static void write_estimate(struct json *json, const struct run_stats *stats) {
    static const char *const names[WAYS + 1] = {
        [WAY_DOWN] = "tail_down", [WAY_UP] = "tail_up", [WAY_ANY] = "tail"};
    const struct render_totals *totals = stats->totals;
    json_count(json, "learning_rays", totals->learning_rays);
    for (int way = 0; way <= WAYS; way++) {
        json_begin_list(json, names[way]);
        for (int i = 0; i < 3; i++) {
            json_decimal(json, NULL, totals->estimate.mean[way][i] / 65536.0, 6);
        }
        json_end_list(json);
    }
    if (stats->compiled->error > 0) {
        json_real(json, "error", stats->compiled->error);
        json_count(json, "unreached_pixels", totals->unreached_pixels);
        json_decimal(json, "estimated_error", totals->estimated_error / 65536.0, 6);
        json_begin_list(json, "worst_pixel");
        json_count(json, NULL, totals->worst_x);
        json_count(json, NULL, totals->worst_y);
        json_end_list(json);
        json_decimal(json, "proved_error", totals->proved_error / 65536.0, 6);
    }
}

static void write_render(struct json *json, const struct run_stats *stats) {
    const struct compiled_scene *compiled = stats->compiled;
    const struct render_totals *totals = stats->totals;
    json_text(json, "scene", stats->scene);
    json_text(json, "arith", stats->arithmetic);
    json_count(json, "depth", compiled->depth_asked);
    json_real(json, "threshold", compiled->threshold);
    json_count(json, "width", compiled->width);
    json_count(json, "height", compiled->height);
    json_count(json, "pixels", (uint64_t)compiled->width * totals->rows);
    json_count(json, "nodes", totals->nodes);
    json_count(json, "rays", totals->rays);
    json_count(json, "shadow_rays", totals->shadow_rays);
    json_count(json, "solid_tests", totals->solid_tests);
    json_count(json, "leaked_rays", totals->leaked_rays);
    json_count(json, "exhausted_pixels", totals->exhausted_pixels);
    if (compiled->estimates) {
        write_estimate(json, stats);
    }
}

/* Two averages of clocks an instruction on the 80386, and the keys of the seconds that they
 * predict. The first is assumed: the mix here has more products than most. The second is what
 * NP2kai's own table of the 386 came to on fig3. Neither is measured. */
static const struct {
    const char *key;
    double clocks;
    const char *source_key, *source;
} clock_tables[] = {
    {"predicted_seconds_RA2", 4.4, "predicted_source_RA2", "4.4 clocks an instruction, assumed"},
    {"predicted_seconds_RA2_NP2kai", 5.7, "predicted_source_RA2_NP2kai",
     "5.7 clocks an instruction, by NP2kai's table of the 386 on fig3"}};

/* Writes the instructions of an emulated CPU, and the seconds predicted for an RA2. The ports' own
 * clocks are in port_cost. */
static void write_processor(struct json *json, const struct processor_report *processor) {
    const struct cost_machine *machine = cost_machine_by_name("RA2");
    json_count(json, "instructions", processor->instructions);
    for (size_t i = 0; i < sizeof clock_tables / sizeof clock_tables[0]; i++) {
        json_decimal(json, clock_tables[i].key,
                     (double)processor->instructions * clock_tables[i].clocks /
                         (machine->megahertz * 1e6),
                     1);
        json_text(json, clock_tables[i].source_key, clock_tables[i].source);
    }
}

static void write_cost(struct json *json, const struct run_stats *stats) {
    const struct port_chain *chain = stats->session->chain;
    double frames[COST_SHOWN];
    if (stats->totals != NULL) {
        stats_predict_frames(stats->compiled, stats->totals, stats->arithmetic,
                             port_chain_writes(chain), frames);
    }
    stats_write_cost(json, &chain->cost, stats->session->options,
                     stats->totals != NULL ? frames : NULL);
}

static void write_pictures(struct json *json, const struct run_stats *stats) {
    struct port_chain *chain = stats->session->chain;
    if (chain->has_board) {
        port_chain_picture(chain);
        json_hexadecimal(json, "frame_crc", picture_crc(chain->rgb), CRC_DIGITS);
        json_count(json, "violations", board_violations(&chain->board));
    } else {
        json_text(json, "frame_crc", NULL);
        json_text(json, "violations", NULL);
    }
    if (stats->photograph != NULL) {
        json_hexadecimal(json, "photograph_crc", picture_crc(stats->photograph), CRC_DIGITS);
    }
}

static void write_stats(struct json *json, const struct run_stats *stats) {
    struct port_chain *chain = stats->session->chain;
    const struct render_totals *totals = stats->totals;
    json_begin_object(json, NULL);
    if (totals != NULL) {
        write_render(json, stats);
    }
    json_count(json, "port_writes", port_chain_writes(chain));
    json_count(json, "port_reads", port_chain_reads(chain));
    if (totals != NULL && totals->rows > 0) {
        double pixels = (double)stats->compiled->width * totals->rows;
        json_decimal(json, "port_writes_per_pixel", (double)port_chain_writes(chain) / pixels, 6);
    }
    json_hexadecimal(json, "trace_hash", trace_hash_value(&chain->hash), HASH_DIGITS);
    write_pictures(json, stats);
    write_cost(json, stats);
    if (stats->adapter != NULL) {
        adapter_bus_write_stats(stats->adapter, json);
    }
    if (stats->processor != NULL) {
        write_processor(json, stats->processor);
    }
    if (totals != NULL && chain->first.has_happened) {
        json_decimal(json, "first_write_seconds",
                     stopwatch_between(&stats->session->began, &chain->first.at), 6);
        json_decimal(json, "first_write_cpu_seconds", chain->first.cpu_seconds, 6);
    }
    if (totals != NULL) {
        json_decimal(json, "render_seconds", totals->seconds, 6);
    }
    json_decimal(json, "total_seconds", stopwatch_seconds(&stats->session->began), 6);
    json_end_object(json);
}

bool stats_commit(const struct run_stats *stats) {
    struct output *output = &stats->session->stats;
    if (output->file == NULL) {
        return true;
    }
    struct json json = {.out = output->file};
    write_stats(&json, stats);
    return output_commit(output);
}
