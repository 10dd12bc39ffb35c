/* SPDX-License-Identifier: MIT */
/* The plots of `superframe measure`: every setting is a mark, every curve that has points is drawn
 * once, in a window that holds it. Nothing is rendered, and gnuplot is not run. */
#include "measure_fixture.h"

enum { DATA_ROWS_MOST = 256, DATA_BLOCKS_MOST = 64, CURVES_MOST = 512 };

/* A block of plots.dat: its rows' numbers. */
struct data_block {
    char name[64];
    size_t count;
    double rows[DATA_ROWS_MOST][3 + MEASURE_TARGETS_MOST];
};

/* A curve of plots.gp: which block in which picture, by which columns. */
struct curve {
    char picture[64], block[64], colour[16], title[64];
    unsigned x, y;
    double x_low, x_high, y_low, y_high; /* the window */
};

struct plots {
    size_t blocks, curves, pictures;
    struct data_block block[DATA_BLOCKS_MOST];
    struct curve curve[CURVES_MOST];
};

static struct plots all_plots[PLANS];

/* ---- Reading -------------------------------------------------------------------------------- */

/* Reads a file of named blocks, each ended by two empty lines. */
static void read_data(const char *at, struct plots *plots) {
    char line[BLOCK_SIZE];
    while (*at != '\0') {
        assert_true(plots->blocks < DATA_BLOCKS_MOST);
        struct data_block *block = &plots->block[plots->blocks++];
        take_line(&at, line);
        assert_int_equal(sscanf(line, "# [%63[^]]]", block->name), 1);
        for (take_line(&at, line); line[0] != '\0'; take_line(&at, line)) {
            double *row = block->rows[block->count++];
            char *end = line;
            assert_true(block->count < DATA_ROWS_MOST);
            for (unsigned i = 0; *end != '\0'; i++) {
                assert_true(i < 3 + MEASURE_TARGETS_MOST);
                const char *begin = end;
                row[i] = strtod(begin, &end);
                assert_true(end != begin);
            }
        }
        take_empty_line(&at);
    }
}

static void take_window(const char *line, struct curve *window) {
    double denominators[2];
    if (sscanf(line, "set xrange [1./%lf:1./%lf]", &denominators[0], &denominators[1]) == 2) {
        window->x_low = 1 / denominators[1];
        window->x_high = 1 / denominators[0];
    } else {
        (void)sscanf(line, "set xrange [%lf:%lf]", &window->x_low, &window->x_high);
    }
    (void)sscanf(line, "set yrange [%lf:%lf]", &window->y_low, &window->y_high);
}

/* Reads the script: what is set holds for the curves below. */
static void read_script(const char *at, struct plots *plots) {
    struct curve set;
    char line[BLOCK_SIZE];
    bool is_open = false; /* a plot is not at its end yet */
    memset(&set, 0, sizeof set);
    while (*at != '\0') {
        take_line(&at, line);
        take_window(line, &set);
        plots->pictures += sscanf(line, "set output '%63[^']'", set.picture) == 1;
        bool is_curve = strncmp(line, "    ", 4) == 0, goes_on = strstr(line, "\\") != NULL;
        assert_int_equal(is_curve, is_open);
        assert_true(strncmp(line, "plot", 4) != 0 || goes_on);
        is_open = goes_on;
        if (is_curve && strstr(line, "notitle") == NULL) {
            assert_true(plots->curves < CURVES_MOST);
            struct curve *curve = &plots->curve[plots->curves++];
            *curve = set;
            assert_int_equal(sscanf(line, " 'plots.dat' index '[%63[^]]]' using %u:%u",
                                    curve->block, &curve->x, &curve->y),
                             3);
            const char *colour = strstr(line, " lc "), *title = strstr(line, " title '");
            assert_true(colour != NULL && title != NULL);
            (void)sscanf(colour, " lc rgb '%15[^']'", curve->colour);
            assert_int_equal(sscanf(title, " title '%63[^']'", curve->title), 1);
        }
    }
    assert_false(is_open);
}

/* Plots all plans, where gnuplot is not found. */
static int make_plots(void **state) {
    static char before[PATH_SIZE];
    char path[64];
    if (make_reports(state) != 0) {
        return -1;
    }
    (void)snprintf(before, sizeof before, "%s", getenv("PATH"));
    (void)setenv("PATH", "/nonexistent", 1);
    for (unsigned i = 0; i < PLANS; i++) {
        assert_int_equal(measure_plot(reports[i].measure), STATUS_DONE);
        (void)snprintf(path, sizeof path, "%s/plots.dat", reports[i].folder);
        read_data(text_of(path), &all_plots[i]);
        (void)snprintf(path, sizeof path, "%s/plots.gp", reports[i].folder);
        read_script(text_of(path), &all_plots[i]);
    }
    return setenv("PATH", before, 1);
}

/* ---- Finding -------------------------------------------------------------------------------- */

static const struct data_block *find_block(const struct plots *plots, const char *name) {
    const struct data_block *found = NULL;
    for (size_t i = 0; i < plots->blocks; i++) {
        if (strcmp(plots->block[i].name, name) == 0) {
            assert_null(found);
            found = &plots->block[i];
        }
    }
    return found;
}

/* Finds the curve of a block in a picture, of which there is one at most; NULL: there is none. */
static const struct curve *find_curve(const struct plots *plots, const char *picture,
                                      const char *block) {
    const struct curve *found = NULL;
    for (size_t i = 0; i < plots->curves; i++) {
        if (strcmp(plots->curve[i].picture, picture) == 0 &&
            strcmp(plots->curve[i].block, block) == 0) {
            assert_null(found);
            found = &plots->curve[i];
        }
    }
    return found;
}

/* Nothing wrong at all stands at the foot of the scale. */
static double shown_of(const struct setting_told *setting) {
    return fmax(setting->mean.wrong, 0.001);
}

static bool is_printed(double printed, double exact) {
    return is_near(printed, exact, 1e-6 + 1e-5 * fabs(exact)) || (isnan(printed) && isnan(exact));
}

/* Checks that a block's next row is of two numbers. */
static void assert_next(const struct data_block *block, size_t *place, double x, double y) {
    assert_non_null(block);
    assert_true(*place < block->count);
    assert_true(is_printed(block->rows[*place][0], x));
    assert_true(is_printed(block->rows[*place][1], y));
    ++*place;
}

/* ---- Marks and fronts ----------------------------------------------------------------------- */

static const char *const arithmetics[] = {"fx", "f32", "f64", "q16", "q16_epsilon"};

static bool is_marked(const struct setting_told *setting, size_t arithmetic, int end) {
    const struct measure_point *point = setting->point;
    int its_end = point->error > 0 ? 2 : strcmp(point->tail, "estimate") == 0 ? 1 : 0;
    return strcmp(point->arithmetic, arithmetics[arithmetic]) == 0 && its_end == end;
}

/* Checks the marks of an arithmetic and one way to end a branch, and in which pictures they are. */
static void check_marks_of(const struct report_made *made, const struct plots *plots,
                           size_t arithmetic, int end) {
    size_t place = 0, drawn[MEASURE_TARGETS_MOST] = {0};
    char name[64], picture[80];
    (void)snprintf(name, sizeof name, "%s-%d", arithmetics[arithmetic], end);
    const struct data_block *block = find_block(plots, name);
    assert_non_null(block);
    for (size_t i = 0; i < made->count; i++) {
        const struct setting_told *setting = &made->settings[i];
        if (is_marked(setting, arithmetic, end)) {
            const double *row = block->rows[place];
            assert_next(block, &place, setting->point->depth, setting->point->threshold);
            assert_true(is_printed(row[2], shown_of(setting)));
            for (size_t j = 0; cost_targets[j].name != NULL; j++) {
                assert_true(is_printed(row[3 + j], setting->mean.seconds[j]));
                drawn[j] += isnan(setting->mean.seconds[j]) ? 0 : 1;
            }
        }
    }
    assert_int_equal(place, block->count);
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        (void)snprintf(picture, sizeof picture, "pareto-%s.png", cost_targets[j].name);
        const struct curve *curve = find_curve(plots, picture, name);
        assert_int_equal(curve != NULL, drawn[j] > 0);
        assert_true(curve == NULL || (curve->x == 4 + j && curve->y == 3));
        assert_true(curve == NULL || strncmp(curve->title, arithmetics[arithmetic],
                                             strlen(arithmetics[arithmetic])) == 0);
    }
}

static void every_setting_is_a_mark_on_every_machine_that_has_it(void **state) {
    (void)state;
    for (unsigned i = 0; i < PLANS; i++) {
        for (size_t j = 0; j < 3 * sizeof arithmetics / sizeof arithmetics[0]; j++) {
            check_marks_of(&reports[i], &all_plots[i], j / 3, (int)(j % 3));
        }
    }
}

/* Tells whether a setting is slower than another and no more right, or more wrong and no quicker.
 */
static bool is_dominated(const struct report_made *made, const struct mean *one, size_t target) {
    for (size_t i = 0; i < made->count; i++) {
        const struct mean *other = &made->settings[i].mean;
        if (other->seconds[target] <= one->seconds[target] && other->wrong <= one->wrong &&
            (other->seconds[target] < one->seconds[target] || other->wrong < one->wrong)) {
            return true;
        }
    }
    return false;
}

static void check_front(const struct report_made *made, const struct plots *plots, size_t target) {
    char name[64], picture[80];
    size_t place = 0;
    (void)snprintf(name, sizeof name, "front-%s", cost_targets[target].name);
    (void)snprintf(picture, sizeof picture, "pareto-%s.png", cost_targets[target].name);
    const struct data_block *block = find_block(plots, name);
    const struct curve *curve = find_curve(plots, picture, name);
    assert_non_null(block);
    for (size_t i = 0; i < made->count; i++) {
        const struct mean *mean = &made->settings[i].mean;
        if (!isnan(mean->seconds[target]) && !is_dominated(made, mean, target)) {
            assert_next(block, &place, mean->seconds[target], shown_of(&made->settings[i]));
        }
    }
    assert_int_equal(place, block->count);
    assert_int_equal(curve != NULL, block->count > 0);
    assert_true(curve == NULL || (curve->x == 1 && curve->y == 2));
}

static void the_front_is_every_setting_that_none_dominates(void **state) {
    (void)state;
    for (unsigned i = 0; i < PLANS; i++) {
        for (size_t j = 0; cost_targets[j].name != NULL; j++) {
            check_front(&reports[i], &all_plots[i], j);
        }
    }
}

/* ---- Curves --------------------------------------------------------------------------------- */

/* Finds the curve against depth that is titled by a threshold. */
static const struct curve *find_depth_curve(const struct plots *plots, const char *threshold) {
    char title[64];
    (void)snprintf(title, sizeof title, "threshold %s", threshold);
    for (size_t i = 0; i < plots->curves; i++) {
        if (strcmp(plots->curve[i].picture, "error-depth.png") == 0 &&
            strcmp(plots->curve[i].title, title) == 0) {
            return &plots->curve[i];
        }
    }
    return NULL;
}

static void check_depth_curves(const struct report_made *made, const struct plots *plots) {
    static const char *const thresholds[] = {"none", "1/256", "1/1024", "1/4096", "1/16384"};
    const struct measure_point *first = made->settings[0].point;
    for (size_t t = 0; t < sizeof thresholds / sizeof thresholds[0]; t++) {
        const struct curve *curve = find_depth_curve(plots, thresholds[t]);
        const struct data_block *block = curve != NULL ? find_block(plots, curve->block) : NULL;
        size_t place = 0;
        for (size_t i = 0; i < made->count; i++) {
            const struct measure_point *point = made->settings[i].point;
            if (strcmp(point->arithmetic, first->arithmetic) == 0 && !(point->error > 0) &&
                strcmp(point->tail, first->tail) == 0 &&
                is_near(point->threshold, threshold_of(thresholds[t]), 1e-9)) {
                assert_next(block, &place, point->depth, shown_of(&made->settings[i]));
            }
        }
        assert_int_equal(place, block != NULL ? block->count : 0);
        assert_true(curve == NULL || (curve->x == 1 && curve->y == 2 && place > 0));
    }
}

static void check_threshold_curve(const struct report_made *made, const struct plots *plots,
                                  const char *arithmetic, const char *tail) {
    char name[64];
    size_t place = 0;
    (void)snprintf(name, sizeof name, "threshold-%s-%s", tail, arithmetic);
    const struct data_block *block = find_block(plots, name);
    const struct curve *curve = find_curve(plots, "error-threshold.png", name);
    assert_non_null(block);
    for (size_t i = 0; i < made->count; i++) {
        const struct measure_point *point = made->settings[i].point;
        if (strcmp(point->arithmetic, arithmetic) == 0 && strcmp(point->tail, tail) == 0 &&
            point->depth == 64 && point->threshold > 0) {
            assert_next(block, &place, point->threshold, shown_of(&made->settings[i]));
        }
    }
    assert_int_equal(place, block->count);
    assert_int_equal(curve != NULL, place > 0);
    assert_true(curve == NULL || (curve->x == 1 && curve->y == 2));
}

/* The whole plan measures what the curves are of. */
static void the_whole_plan_has_every_curve(void **state) {
    static const char *const thresholds[] = {"none", "1/256", "1/1024", "1/4096", "1/16384"};
    const struct plots *plots = &all_plots[0];
    char name[64];
    (void)state;
    for (size_t i = 0; i < 5; i++) {
        const struct curve *curve = find_depth_curve(plots, thresholds[i]);
        assert_non_null(curve);
        assert_true(find_block(plots, curve->block)->count > 4);
        (void)snprintf(name, sizeof name, "threshold-black-%s", arithmetics[i]);
        assert_non_null(find_curve(plots, "error-threshold.png", name));
        (void)snprintf(name, sizeof name, "threshold-estimate-%s", arithmetics[i]);
        assert_int_equal(find_curve(plots, "error-threshold.png", name) != NULL, i < 3);
    }
}

static void every_curve_that_has_points_is_drawn(void **state) {
    static const char *const tails[] = {"black", "estimate"};
    (void)state;
    for (unsigned i = 0; i < PLANS; i++) {
        check_depth_curves(&reports[i], &all_plots[i]);
        for (size_t j = 0; j < 2 * sizeof arithmetics / sizeof arithmetics[0]; j++) {
            check_threshold_curve(&reports[i], &all_plots[i], arithmetics[j / 2], tails[j % 2]);
        }
    }
}

/* ---- Pictures ------------------------------------------------------------------------------- */

static void assert_in_window(const struct curve *curve, const struct data_block *block) {
    size_t seen = 0;
    assert_non_null(block);
    for (size_t i = 0; i < block->count; i++) {
        double x = block->rows[i][curve->x - 1], y = block->rows[i][curve->y - 1];
        if (!isnan(x)) {
            seen++;
            assert_true(x >= curve->x_low && x <= curve->x_high);
            assert_true(y >= curve->y_low && y <= curve->y_high);
        }
    }
    assert_true(seen > 0);
}

/* Two curves of one picture must be told apart by title, two arithmetics by colour too. */
static void assert_distinct(const struct curve *a, const struct curve *b) {
    size_t length = strcspn(a->title, ","), other = strcspn(b->title, ",");
    bool is_same = length == other && strncmp(a->title, b->title, length) == 0;
    assert_string_not_equal(a->title, b->title);
    assert_int_equal(strcmp(a->colour, b->colour) == 0, is_same);
}

static void pictures_hold_what_is_drawn_and_tell_it_apart(void **state) {
    (void)state;
    for (unsigned i = 0; i < PLANS; i++) {
        const struct plots *plots = &all_plots[i];
        for (size_t j = 0; j < plots->curves; j++) {
            const struct curve *curve = &plots->curve[j];
            assert_in_window(curve, find_block(plots, curve->block));
            for (size_t k = 0; k < j; k++) {
                if (strcmp(plots->curve[k].picture, curve->picture) == 0) {
                    assert_distinct(&plots->curve[k], curve);
                }
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_setting_is_a_mark_on_every_machine_that_has_it),
        cmocka_unit_test(the_front_is_every_setting_that_none_dominates),
        cmocka_unit_test(the_whole_plan_has_every_curve),
        cmocka_unit_test(every_curve_that_has_points_is_drawn),
        cmocka_unit_test(pictures_hold_what_is_drawn_and_tell_it_apart),
    };
    return cmocka_run_group_tests(tests, make_plots, discard_reports);
}
