/* SPDX-License-Identifier: MIT */
/* What the pages of `superframe measure` say outside of their tables of settings: what the paper's
 * setting loses, how it was measured, the machines, the pictures, and numbers as text. */
#include "lab/measure/page.h"
#include "measure_fixture.h"

/* Finds the n-th paragraph of a section; NULL: there is none. */
static const char *paragraph_of(const struct page *page, const char *heading, unsigned n) {
    for (size_t i = find_section(page, heading); i < page->count && page->blocks[i].kind != HEADING;
         i++) {
        if (page->blocks[i].kind == PARAGRAPH && n-- == 0) {
            return page->blocks[i].text;
        }
    }
    return NULL;
}

/* Reads the n-th number of a text, of those that begin a word. */
static double number_in(const char *text, unsigned n) {
    for (const char *at = text; (at = strpbrk(at, "0123456789")) != NULL;) {
        char *end;
        double value = strtod(at, &end);
        if ((at == text || strchr(" (", at[-1]) != NULL) && n-- == 0) {
            return value;
        }
        at = end;
    }
    fail_msg("\"%s\": so many numbers are not there", text);
    return NAN;
}

/* ---- The paper's setting -------------------------------------------------------------------- */

static bool is_fx(const struct setting_told *setting) {
    return strcmp(setting->point->arithmetic, "fx") == 0;
}

static const struct setting_told *find_paper(const struct report_made *made) {
    for (size_t i = 0; i < made->count; i++) {
        const struct measure_point *point = made->settings[i].point;
        if (is_fx(&made->settings[i]) && point->depth == 10 && !(point->threshold > 0) &&
            !(point->error > 0) && strcmp(point->tail, "black") == 0) {
            return &made->settings[i];
        }
    }
    return NULL;
}

/* Finds the fx setting of the fewest rays that is no worse than another; itself, if none is. */
static const struct setting_told *find_better(const struct report_made *made,
                                              const struct setting_told *than) {
    const struct setting_told *best = than;
    for (size_t i = 0; i < made->count; i++) {
        const struct setting_told *setting = &made->settings[i];
        if (is_fx(setting) && setting->mean.wrong <= than->mean.wrong &&
            setting->mean.rays < best->mean.rays) {
            best = setting;
        }
    }
    return best;
}

static void check_paper(const struct report_made *made) {
    static const char heading[] = "What the paper's N = 10 costs and loses";
    const struct setting_told *paper = find_paper(made);
    const char *lost = paragraph_of(&made->page, heading, 0);
    const char *gain = paragraph_of(&made->page, heading, 1);
    assert_int_equal(lost != NULL, paper != NULL);
    if (paper == NULL) {
        return;
    }
    assert_true(is_near(number_in(lost, 1), paper->mean.rays, 0.51));
    assert_true(is_near(number_in(lost, 2), paper->mean.wrong, 0.0051));
    assert_true(is_near(number_in(lost, 3), paper->mean.worst, 0.0051));
    const struct setting_told *better = find_better(made, paper);
    assert_int_equal(gain != NULL, better != paper);
    if (gain != NULL) {
        const char *is_no_worse = strstr(gain, " is no worse: ");
        double times = paper->mean.rays / better->mean.rays;
        assert_non_null(is_no_worse);
        assert_true(names_setting(gain, better->point));
        assert_true(is_near(number_in(is_no_worse, 0), better->mean.wrong, 0.0051));
        assert_true(is_near(number_in(is_no_worse, 1), better->mean.rays, 0.51));
        assert_true(is_near(number_in(is_no_worse, 2), times, 0.051));
    }
}

static void the_papers_setting_is_held_against_what_is_no_worse(void **state) {
    (void)state;
    check_reports(check_paper);
}

/* A setting with more rays than the paper's is no gain, however right it is. */
static void nothing_is_called_fewer_that_is_more(void **state) {
    static struct report_made made;
    (void)state;
    made.measure = plan_measure("measure fig3 -o m --arith fx");
    draw_results(made.measure, 1);
    for (size_t i = 0; i < made.measure->points.count; i++) {
        struct measure_point *point = &made.measure->points.points[i];
        bool is_paper = point->depth == 10 && !(point->threshold > 0) && !(point->error > 0);
        point->events.rays = is_paper ? 16000 : 160000;
        point->wrong = is_paper ? 1 : 0;
    }
    made.count = settings_of(made.measure, made.settings);
    assert_int_equal(measure_gather(made.measure), STATUS_DONE);
    assert_int_equal(measure_report(made.measure), STATUS_DONE);
    read_markdown(text_of("m/report.md"), &made.page);
    check_paper(&made);
    discard_measure(made.measure);
}

/* ---- Method, machines, words ---------------------------------------------------------------- */

static void check_method(const struct report_made *made) {
    static const char heading[] = "How it was measured";
    const struct measure *measure = made->measure;
    char begin[256] = "Scenes: ", end[64];
    double least = 100, told = 0;
    for (size_t i = 0; i < measure->scene_count; i++) {
        strcat(strcat(begin, i > 0 ? ", " : ""), measure->scenes[i].name);
        least = fmin(least, measure->scenes[i].oracle);
    }
    (void)snprintf(begin + strlen(begin), 64, "; %u x %u pixels.", measure->points.points[0].width,
                   measure->points.points[0].height);
    (void)snprintf(end, sizeof end, ": %zu points, in table.csv.", measure->points.count);
    assert_memory_equal(paragraph_of(&made->page, heading, 0), begin, strlen(begin));
    assert_non_null(strstr(paragraph_of(&made->page, heading, 0), "depth level 255"));
    const char *oracle = strstr(paragraph_of(&made->page, heading, 1), " at N = 10: ");
    assert_non_null(oracle);
    bool is_least = strstr(oracle, ": at least ") != NULL;
    assert_int_equal(is_least, least < 100);
    oracle += strlen(" at N = 10: ") + (is_least ? strlen("at least ") : 0);
    assert_int_equal(sscanf(oracle, "%lf %% of the pixels are the same", &told), 1);
    assert_true(told <= least && least - told < 0.01 + 1e-9); /* never rounded up */
    const char *seconds = paragraph_of(&made->page, heading, 2);
    assert_string_equal(seconds + strlen(seconds) - strlen(end), end);
}

static void check_machines(const struct report_made *made) {
    size_t place = find_section(&made->page, "The machines"), count = 0;
    char expected[BLOCK_SIZE];
    for (; cost_targets[count].name != NULL; count++) {
        const struct cost_target *target = &cost_targets[count];
        (void)snprintf(expected, sizeof expected, "%s|%s", target->label, target->source);
        const char *row = next_row(&made->page, &place);
        assert_non_null(row);
        assert_string_equal(row, expected);
    }
    assert_null(next_row(&made->page, &place));
    (void)snprintf(expected, sizeof expected, "for each of %zu machines", count);
    assert_int_equal(made->page.blocks[1].kind, PARAGRAPH);
    assert_non_null(strstr(made->page.blocks[1].text, expected));
}

static void scenes_points_and_machines_are_named(void **state) {
    (void)state;
    check_reports(check_method);
    check_reports(check_machines);
}

/* ---- Pictures ------------------------------------------------------------------------------- */

enum { OTHER_PICTURES = 6, PICTURES_MOST = OTHER_PICTURES + MEASURE_TARGETS_MOST };

static size_t name_pictures(char files[PICTURES_MOST][64]) {
    static const char *const others[OTHER_PICTURES] = {
        "difference-paper.png", "difference-fx.png",   "difference-error.png",
        "error-depth.png",      "error-threshold.png", "difference-q16-epsilon.png"};
    size_t count = 0;
    for (; count < OTHER_PICTURES; count++) {
        strcpy(files[count], others[count]);
    }
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        (void)snprintf(files[count++], 64, "pareto-%s.png", cost_targets[j].name);
    }
    return count;
}

/* Counts the places of a page where a file is shown. */
static size_t times_shown(const struct page *page, const char *file) {
    size_t times = 0, length = strlen(file);
    for (size_t i = 0; i < page->count; i++) {
        const struct block *block = &page->blocks[i];
        times += block->kind == PICTURE && strncmp(block->text, file, length) == 0 &&
                 block->text[length] == '|';
    }
    return times;
}

static void pictures_are_shown_once_where_they_are_there(void **state) {
    static char files[PICTURES_MOST][64];
    static struct page page;
    size_t count = name_pictures(files);
    struct measure *measure = plan_measure(plans[0]);
    uint64_t random = 7;
    (void)state;
    draw_results(measure, 1);
    assert_int_equal(measure_gather(measure), STATUS_DONE);
    for (unsigned round = 0; round < 4; round++) {
        uint64_t there = round == 0 ? 0 : round == 1 ? UINT64_MAX : splitmix64(&random);
        for (size_t i = 0; i < count; i++) {
            char line[128];
            (void)snprintf(line, sizeof line, "%s m/%s", (there >> i & 1) != 0 ? "touch" : "rm -f",
                           files[i]);
            assert_status(line, 0);
        }
        assert_int_equal(measure_report(measure), STATUS_DONE);
        read_markdown(text_of("m/report.md"), &page);
        for (size_t i = 0; i < count; i++) {
            assert_int_equal(times_shown(&page, files[i]), there >> i & 1);
        }
    }
    discard_measure(measure);
}

/* ---- Numbers as text ------------------------------------------------------------------------ */

static void seconds_and_thresholds_are_told_as_people_do(void **state) {
    static const struct {
        double seconds;
        const char *said;
    } times[] = {
        {0.00012345, "0.000123 s"}, {0.5, "0.5 s"},  {119.4, "119 s"},    {120, "2 min"},
        {7169, "119 min"},          {7200, "2.0 h"}, {360000, "100.0 h"}, {(double)NAN, "–"}};
    static const struct {
        double threshold;
        const char *said;
    } thresholds[] = {
        {0, "none"},       {1, "1/1"},      {1.0 / 4096, "1/4096"}, {1.0 / 65536, "1/65536"},
        {0.001, "1/1000"}, {0.3, "1/3.333"}};
    char text[32];
    (void)state;
    for (size_t i = 0; i < sizeof times / sizeof times[0]; i++) {
        assert_string_equal(page_seconds(times[i].seconds, text), times[i].said);
    }
    for (size_t i = 0; i < sizeof thresholds / sizeof thresholds[0]; i++) {
        assert_string_equal(page_threshold(thresholds[i].threshold, text), thresholds[i].said);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_papers_setting_is_held_against_what_is_no_worse),
        cmocka_unit_test(nothing_is_called_fewer_that_is_more),
        cmocka_unit_test(scenes_points_and_machines_are_named),
        cmocka_unit_test(pictures_are_shown_once_where_they_are_there),
        cmocka_unit_test(seconds_and_thresholds_are_told_as_people_do),
    };
    return cmocka_run_group_tests(tests, make_reports, discard_reports);
}
