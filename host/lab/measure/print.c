/* SPDX-License-Identifier: MIT */
/* Prints what `superframe measure` has measured, as JSON. */
#include "base/complain.h"
#include "base/json.h"
#include "lab/measure/measure.h"

/* As in points.csv: what was read from there is printed like what was measured. */
enum { PLACES = 6, PSNR_PLACES = 4 };

static void write_choice(struct json *json, const char *arithmetic, const char *tail,
                         unsigned depth, double threshold, double error) {
    json_text(json, "arithmetic", arithmetic);
    json_text(json, "tail", tail);
    json_count(json, "depth", depth);
    json_real(json, "threshold", threshold);
    json_real(json, "error", error);
}

/* Writes a setting: its means over the scenes, and by machine the seconds of one picture. A setting
 * is on a machine's front where no other one is at least as good. */
static void write_setting(struct json *json, const struct measure_settings *settings, size_t i) {
    const struct measure_setting *setting = &settings->settings[i];
    json_begin_object(json, NULL);
    write_choice(json, setting->arithmetic, setting->tail, setting->depth, setting->threshold,
                 setting->error);
    json_decimal(json, "percent_wrong", setting->wrong, PLACES);
    json_decimal(json, "percent_wrong_worst", setting->worst, PLACES);
    json_decimal(json, "percent_apart", setting->apart, PLACES);
    json_decimal(json, "rays_per_pixel", setting->rays, PLACES);
    json_begin_object(json, "machines");
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        json_begin_object(json, cost_targets[j].name);
        json_real(json, "seconds", setting->seconds[j]);
        json_flag(json, "on_front", measure_is_on_front(settings, i, j));
        json_end_object(json);
    }
    json_end_object(json);
    json_end_object(json);
}

static void write_point(struct json *json, const struct measure *measure,
                        const struct measure_point *point) {
    json_begin_object(json, NULL);
    json_text(json, "scene", point->scene);
    write_choice(json, point->arithmetic, point->tail, point->depth, point->threshold,
                 point->error);
    json_count(json, "width", point->width);
    json_count(json, "height", point->height);
    json_text(json, "colour", point->colour);
    json_text(json, "model", point->model);
    json_count(json, "rays", point->events.rays);
    json_count(json, "shadow_rays", point->events.shadow_rays);
    json_count(json, "nodes", point->events.nodes);
    json_count(json, "solid_tests", point->events.solid_tests);
    json_count(json, "leaked_rays", point->leaked_rays);
    json_count(json, "port_writes", point->port_writes);
    json_decimal(json, "seconds", point->seconds, PLACES);
    json_decimal(json, "percent_wrong", point->wrong, PLACES);
    json_decimal(json, "percent_apart", point->apart, PLACES);
    json_count(json, "largest_error", point->largest);
    json_decimal(json, "rmse", point->rmse, PLACES);
    json_decimal(json, "psnr", point->psnr, PSNR_PLACES); /* null: the pictures are equal */
    json_decimal(json, "delta_e_mean", point->colour_mean, PLACES);
    json_decimal(json, "delta_e_999", point->colour_high, PLACES);
    json_begin_object(json, "machines");
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        json_real(json, cost_targets[j].name, measure_predict(measure, point, &cost_targets[j]));
    }
    json_end_object(json);
    json_end_object(json);
}

int measure_print(struct measure *measure) {
    struct json json = {.out = stdout};
    if (!measure->options->json) {
        return STATUS_DONE;
    }
    json_begin_object(&json, NULL);
    json_begin_list(&json, "scenes");
    for (size_t i = 0; i < measure->scene_count; i++) {
        json_begin_object(&json, NULL);
        json_text(&json, "name", measure->scenes[i].name);
        json_text(&json, "digest", measure->scenes[i].digest);
        json_end_object(&json);
    }
    json_end_list(&json);
    json_begin_list(&json, "settings");
    for (size_t i = 0; i < measure->settings.count; i++) {
        write_setting(&json, &measure->settings, i);
    }
    json_end_list(&json);
    json_begin_list(&json, "points");
    for (size_t i = 0; i < measure->points.count; i++) {
        write_point(&json, measure, &measure->points.points[i]);
    }
    json_end_list(&json);
    json_end_object(&json);
    return STATUS_DONE;
}
