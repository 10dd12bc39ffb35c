/* SPDX-License-Identifier: MIT */
/* What the pages and the table of `superframe measure` say, held against the points that they are
 * made of: the results are drawn by a seed, nothing is rendered. */
#include "measure_fixture.h"

/* Holds a time as a reader is told it against seconds: three digits, whole minutes, tenths of an
 * hour, a dash for none. */
static void assert_time(const char *text, double seconds) {
    char unit[16] = "";
    double told = 0;
    if (isnan(seconds)) {
        assert_string_equal(text, "–");
        return;
    }
    assert_int_equal(sscanf(text, "%lf %15s", &told, unit), 2);
    double unit_seconds = strcmp(unit, "s") == 0 ? 1 : strcmp(unit, "min") == 0 ? 60 : 3600;
    assert_true(strcmp(unit, "h") == 0 || unit_seconds < 3600);
    double tolerance = unit_seconds < 2 ? 0.0051 * seconds : unit_seconds * 0.51;
    assert_true(is_near(told * unit_seconds, seconds, unit_seconds > 60 ? 181 : tolerance));
}

/* ---- Both pages ----------------------------------------------------------------------------- */

static void check_pages(const struct report_made *made) {
    static const char *const sections[] = {"What a cut branch counts as", "An accuracy asked for",
                                           "Size, colours and model"};
    assert_sound(&made->page);
    assert_sound(&made->html);
    assert_same_page(&made->page, &made->html);
    for (size_t i = 0; i < sizeof sections / sizeof sections[0]; i++) {
        size_t place = find_section(&made->page, sections[i]);
        assert_true(place == made->page.count || next_row(&made->page, &place) != NULL);
    }
}

static void both_pages_are_sound_and_say_the_same(void **state) {
    (void)state;
    check_reports(check_pages);
}

/* ---- table.csv ------------------------------------------------------------------------------ */

static void check_table(const struct report_made *made) {
    char path[64];
    (void)snprintf(path, sizeof path, "%s/table.csv", made->folder);
    const char *at = text_of(path);
    char line[BLOCK_SIZE], text[BLOCK_SIZE], key[MEASURE_KEY_SIZE], *cells[CELLS_MOST];
    take_line(&at, line);
    size_t count = split(text, line, ',', cells), fixed = 11;
    assert_string_equal(cells[0], "scene");
    assert_string_equal(cells[fixed - 1], "percent_wrong");
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        assert_true(fixed + j < count && strncmp(cells[fixed + j], "seconds_", 8) == 0);
        assert_string_equal(cells[fixed + j] + 8, cost_targets[j].name);
    }
    for (size_t i = 0; i < made->measure->points.count; i++) {
        const struct measure_point *point = &made->measure->points.points[i];
        take_line(&at, line);
        measure_key(point, key);
        assert_memory_equal(line, key, strlen(key));
        assert_int_equal(split(text, line, ',', cells), count);
        assert_true(is_near(number(cells[fixed - 1]), point->wrong, 1e-6));
        for (size_t j = 0; cost_targets[j].name != NULL; j++) {
            double seconds = predict(made->measure, point, &cost_targets[j]);
            assert_int_equal(cells[fixed + j][0] == '\0', isnan(seconds));
            assert_true(isnan(seconds) ||
                        is_near(number(cells[fixed + j]), seconds, 1e-5 * seconds));
        }
    }
    assert_string_equal(at, "");
}

static void the_table_has_every_point_once_with_its_seconds(void **state) {
    (void)state;
    check_reports(check_table);
}

/* ---- Advice --------------------------------------------------------------------------------- */

/* Finds the least time on a machine that is at most so wrong; infinite: none is. */
static double least_seconds(const struct report_made *made, size_t target, double wrong_most) {
    double least = INFINITY;
    for (size_t i = 0; i < made->count; i++) {
        if (made->settings[i].mean.wrong <= wrong_most) {
            least = fmin(least, made->settings[i].mean.seconds[target]);
        }
    }
    return least;
}

static void assert_advice(const struct report_made *made, size_t target, double wrong_most,
                          char *const *cells) {
    double least = least_seconds(made, target, wrong_most);
    size_t named = 0;
    if (isinf(least)) {
        assert_string_equal(cells[0], "none of these");
        assert_string_equal(cells[1], "–");
        return;
    }
    assert_time(cells[1], least);
    for (size_t i = 0; i < made->count; i++) {
        if (names_setting(cells[0], made->settings[i].point)) {
            named++;
            assert_true(made->settings[i].mean.wrong <= wrong_most);
            assert_true(is_near(made->settings[i].mean.seconds[target], least, 0));
        }
    }
    assert_int_equal(named, 1);
}

static void check_advice(const struct report_made *made) {
    static const double most[] = {10, 1, 0.1};
    size_t place = find_section(&made->page, "Which setting");
    char text[BLOCK_SIZE], *cells[CELLS_MOST];
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        const char *row = next_row(&made->page, &place);
        assert_non_null(row);
        assert_int_equal(split(text, row, '|', cells), 7);
        assert_string_equal(cells[0], cost_targets[j].label);
        for (size_t i = 0; i < 3; i++) {
            assert_advice(made, j, most[i], cells + 1 + 2 * i);
        }
    }
    assert_null(next_row(&made->page, &place));
}

static void each_machine_is_advised_the_cheapest_setting_that_is_right_enough(void **state) {
    (void)state;
    check_reports(check_advice);
}

/* Finds a setting of the grid whose tail is black; NULL: there is none. */
static const struct setting_told *find_black(const struct report_made *made, const char *arithmetic,
                                             unsigned depth, double threshold) {
    for (size_t i = 0; i < made->count; i++) {
        const struct measure_point *point = made->settings[i].point;
        if (strcmp(point->arithmetic, arithmetic) == 0 && point->depth == depth &&
            is_near(point->threshold, threshold, 1e-9) && !(point->error > 0) &&
            strcmp(point->tail, "black") == 0) {
            return &made->settings[i];
        }
    }
    return NULL;
}

static void check_choice(const struct report_made *made) {
    static const char *const names[] = {"fx", "f32", "f64"};
    size_t place = find_section(&made->page, "Which arithmetic for which machine");
    bool is_told = find_black(made, "fx", 64, 1.0 / 4096) != NULL &&
                   find_black(made, "f32", 64, 1.0 / 4096) != NULL;
    char text[BLOCK_SIZE], *cells[CELLS_MOST];
    assert_int_equal(place < made->page.count, is_told);
    for (size_t j = 0; is_told && cost_targets[j].name != NULL; j++) {
        double least = INFINITY, taken = NAN;
        const char *row = next_row(&made->page, &place);
        assert_non_null(row);
        assert_int_equal(split(text, row, '|', cells), 5);
        assert_string_equal(cells[0], cost_targets[j].label);
        for (size_t i = 0; i < 3; i++) {
            const struct setting_told *setting = find_black(made, names[i], 64, 1.0 / 4096);
            double seconds = setting != NULL ? setting->mean.seconds[j] : (double)NAN;
            assert_time(cells[2 + i], seconds);
            least = fmin(least, seconds);
            taken = strcmp(cells[1], names[i]) == 0 ? seconds : taken;
        }
        assert_true(is_near(taken, least, 0));
    }
    assert_true(!is_told || next_row(&made->page, &place) == NULL);
}

static void each_machine_takes_the_arithmetic_that_is_quickest_on_it(void **state) {
    (void)state;
    check_reports(check_choice);
}

/* ---- Rows of one setting each --------------------------------------------------------------- */

/* Checks one row of the means of a setting: cells of wrong, rays, and where asked apart and the
 * worst scene; NULL: not in this row. */
static void assert_means(const struct mean *mean, const char *wrong, const char *rays,
                         const char *worst, const char *apart) {
    assert_true(is_near(number(wrong), mean->wrong, 5.1e-4));
    assert_true(is_near(number(rays), mean->rays, 0.051));
    assert_true(worst == NULL || is_near(number(worst), mean->worst, 5.1e-4));
    assert_true(apart == NULL || is_near(number(apart), mean->apart, 5.1e-4));
}

static void check_tails(const struct report_made *made) {
    size_t place = find_section(&made->page, "What a cut branch counts as");
    char text[BLOCK_SIZE], *cells[CELLS_MOST];
    for (size_t i = 0; i < made->count; i++) {
        const struct measure_point *point = made->settings[i].point;
        if (strcmp(point->tail, "estimate") != 0 || point->error > 0) {
            continue;
        }
        const struct setting_told *black =
            find_black(made, point->arithmetic, point->depth, point->threshold);
        const char *row = next_row(&made->page, &place);
        assert_non_null(row);
        assert_int_equal(split(text, row, '|', cells), 7);
        assert_string_equal(cells[0], point->arithmetic);
        assert_int_equal((int)number(cells[1]), point->depth);
        assert_true(is_near(threshold_of(cells[2]), point->threshold, 1e-9));
        if (black != NULL) {
            assert_means(&black->mean, cells[3], cells[4], NULL, NULL);
        } else {
            assert_string_equal(cells[3], "–");
            assert_string_equal(cells[4], "–");
        }
        assert_means(&made->settings[i].mean, cells[5], cells[6], NULL, NULL);
    }
    assert_null(next_row(&made->page, &place));
}

static void check_errors(const struct report_made *made) {
    size_t place = find_section(&made->page, "An accuracy asked for");
    char text[BLOCK_SIZE], *cells[CELLS_MOST];
    for (size_t i = 0; i < made->count; i++) {
        if (made->settings[i].point->error > 0) {
            const char *row = next_row(&made->page, &place);
            assert_non_null(row);
            assert_int_equal(split(text, row, '|', cells), 5);
            assert_string_equal(cells[0], made->settings[i].point->arithmetic);
            assert_true(is_near(number(cells[1]), made->settings[i].point->error, 1e-6));
            assert_means(&made->settings[i].mean, cells[2], cells[4], cells[3], NULL);
        }
    }
    assert_null(next_row(&made->page, &place));
}

static void check_arithmetics(const struct report_made *made) {
    static const char *const names[] = {"fx", "f32", "f64", "q16", "q16_epsilon"};
    size_t place = find_section(&made->page, "Arithmetics");
    char text[BLOCK_SIZE], *cells[CELLS_MOST];
    for (size_t i = 0; i < 5; i++) {
        const struct setting_told *setting = find_black(made, names[i], 64, 1.0 / 65536);
        if (setting != NULL) {
            const char *row = next_row(&made->page, &place);
            assert_non_null(row);
            assert_int_equal(split(text, row, '|', cells), 6);
            assert_string_equal(cells[0], names[i]);
            assert_means(&setting->mean, cells[3], cells[5], cells[4], cells[2]);
        }
    }
    assert_null(next_row(&made->page, &place));
}

static void check_others(const struct report_made *made) {
    size_t place = find_section(&made->page, "Size, colours and model");
    char text[BLOCK_SIZE], *cells[CELLS_MOST], arithmetic[16], threshold[32];
    for (size_t i = 0; i < made->measure->points.count; i++) {
        const struct measure_point *point = &made->measure->points.points[i];
        unsigned depth, width, height;
        if (is_of_first_kind(made->measure, point)) {
            continue;
        }
        const char *row = next_row(&made->page, &place);
        assert_non_null(row);
        assert_int_equal(split(text, row, '|', cells), 10);
        assert_string_equal(cells[0], point->scene);
        assert_int_equal(sscanf(cells[1], "%15[^,], N = %u, %31s", arithmetic, &depth, threshold),
                         3);
        assert_string_equal(arithmetic, point->arithmetic);
        assert_int_equal(depth, point->depth);
        assert_true(is_near(threshold_of(threshold), point->threshold, 1e-9));
        assert_int_equal(sscanf(cells[2], "%ux%u", &width, &height), 2);
        assert_true(width == point->width && height == point->height);
        assert_string_equal(cells[3], point->colour);
        assert_string_equal(cells[4], point->model);
        assert_true(is_near(number(cells[5]), point->wrong, 5.1e-4));
        assert_int_equal((int)number(cells[6]), point->largest);
        assert_true(is_near(number(cells[7]), point->colour_mean, 5.1e-4));
        assert_true(is_near(number(cells[8]), (double)point->events.rays, 0));
        assert_true(is_near(number(cells[9]), (double)point->port_writes, 0));
    }
    assert_null(next_row(&made->page, &place));
}

static void every_setting_has_its_rows_with_its_means(void **state) {
    (void)state;
    check_reports(check_tails);
    check_reports(check_errors);
    check_reports(check_arithmetics);
    check_reports(check_others);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_pages_are_sound_and_say_the_same),
        cmocka_unit_test(the_table_has_every_point_once_with_its_seconds),
        cmocka_unit_test(each_machine_is_advised_the_cheapest_setting_that_is_right_enough),
        cmocka_unit_test(each_machine_takes_the_arithmetic_that_is_quickest_on_it),
        cmocka_unit_test(every_setting_has_its_rows_with_its_means),
    };
    return cmocka_run_group_tests(tests, make_reports, discard_reports);
}
