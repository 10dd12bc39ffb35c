/* SPDX-License-Identifier: MIT */
/* superframe paper, as its users call it: all that it writes, and nothing where it fails.
 *
 * SUPERFRAME names the program (build/sanitized/superframe). The pictures are a hundredth of the
 * paper's, so that all of it takes seconds. */
#include "lab/paper/paper.h"
#include "png_file.h"
#include "shell_fixture.h"

#define PAPER_RUN "$SUPERFRAME paper --size 32x20 --jobs 2 "

struct place {
    char before[PATH_SIZE], folder[64];
};

/* One folder for all tests: the first makes the paper in it, the others look at it. */
static int enter_group(void **state) {
    static struct place place = {"", "/tmp/superframe-paper-XXXXXX"};
    char program[2 * PATH_SIZE];
    const char *name = getenv("SUPERFRAME");
    name = name != NULL ? name : "build/sanitized/superframe";
    *state = &place;
    if (getcwd(place.before, sizeof place.before) == NULL || mkdtemp(place.folder) == NULL) {
        return -1;
    }
    (void)snprintf(program, sizeof program, "%s/%s", name[0] == '/' ? "" : place.before, name);
    /* A sanitizer's report must not pass for one of the program's own statuses. */
    return access(program, X_OK) | setenv("SUPERFRAME", program, 1) |
           setenv("ASAN_OPTIONS", "exitcode=99", 1) |
           setenv("UBSAN_OPTIONS", "exitcode=99:print_stacktrace=1", 1) | chdir(place.folder);
}

static int leave_group(void **state) {
    const struct place *place = *state;
    char line[128];
    (void)snprintf(line, sizeof line, "rm -rf %s", place->folder);
    return chdir(place->before) | system(line);
}

static bool has_gnuplot(void) {
    return run("command -v gnuplot") == 0;
}

/* ---- What it writes ------------------------------------------------------------------------- */

static void every_figure_is_there(void **state) {
    (void)state;
    assert_status(PAPER_RUN "-o made/", 0);
    int figures = 0;
    for (; paper_figures[figures].file != NULL; figures++) {
        char path[128];
        (void)snprintf(path, sizeof path, "made/%s.png", paper_figures[figures].file);
        assert_true(is_there(path));
    }
    assert_int_equal(figures, 12);
    assert_status("ls -A made | wc -l", 0);
    /* The figures, the sheet, the data, the script, two reports, and two plots. */
    int files = atoi(text_of("out"));
    assert_int_equal(files, 12 + 5 + (has_gnuplot() ? 2 : 0));
    assert_int_equal(is_there("made/fig7-rays.png"), has_gnuplot());
    assert_int_equal(is_there("made/fig7-tests.png"), has_gnuplot());
}

/* Each is what render makes of the same scene. */
static void figures_are_renders(void **state) {
    (void)state;
    static const char *const lines[][2] = {
        {"fig3a", "fig3 --depth 5 --size 32x20"},
        {"fig3b", "fig3 --depth 10 --size 32x20"},
        {"fig4a", "fig4a --depth 15 --size 64x40"},
        {"fig4b", "fig4b --depth 10 --size 64x40"},
        {"fig5", "fig5 --size 32x20"},
        {"fig6a", "fig6a --colour dither --size 32x20"},
        {"fig6b", "fig6b --colour dither --size 32x20"},
        {"figA-4bits", "figA --colour bits:4 --size 32x20"},
        {"figA-5bits", "figA --colour bits:5 --size 32x20"},
        {"figA-8bits", "figA --colour full --size 32x20"},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        char line[256];
        (void)snprintf(line, sizeof line, "$SUPERFRAME render %s -o - | cmp - made/%s.png",
                       lines[i][1], lines[i][0]);
        assert_status(line, 0);
    }
}

static struct png_image read_made(const char *name) {
    struct png_image image = {0, 0, NULL};
    struct png_error error;
    char path[128];
    (void)snprintf(path, sizeof path, "made/%s.png", name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(read_png(file, &image, &error), PNG_OK);
    (void)fclose(file);
    return image;
}

/* Three in a row, each dot the mean of four, 12 dots apart and from the edge. */
static void the_contact_sheet_has_every_figure_at_half_its_size(void **state) {
    (void)state;
    struct png_image sheet = read_made("contact-sheet");
    assert_int_equal(sheet.width, 3 * (320 + 12) + 12);
    assert_int_equal(sheet.height, 4 * (200 + 12) + 12);
    for (unsigned i = 0; paper_figures[i].file != NULL; i++) {
        struct png_image figure = read_made(paper_figures[i].file);
        const size_t left = 12 + i % 3 * (320 + 12), top = 12 + i / 3 * (200 + 12);
        for (size_t y = 0; y < 200; y++) {
            for (size_t x = 0; x < 320; x++) {
                for (size_t j = 0; j < 3; j++) {
                    const uint8_t *dots = &figure.rgb[(2 * y * 640 + 2 * x) * 3 + j];
                    int sum = dots[0] + dots[3] + dots[640 * 3] + dots[641 * 3];
                    assert_int_equal(sheet.rgb[((top + y) * sheet.width + left + x) * 3 + j],
                                     (sum + 2) / 4);
                }
            }
        }
        free_png(&figure);
    }
    free_png(&sheet);
}

/* The cells of a row of the Markdown table; returns how many. The row is cut up. */
static int split(char *row, char **cells, int most) {
    int count = 0;
    for (char *cell = strtok(row, "|"); cell != NULL && count < most; cell = strtok(NULL, "|")) {
        cells[count++] = cell;
    }
    return count;
}

static void nine_claims_each_with_a_verdict(void **state) {
    (void)state;
    enum { CELLS = 6 };
    FILE *file = fopen("made/claims.md", "r");
    char line[8192];
    int claims = 0;
    assert_non_null(file);
    while (fgets(line, sizeof line, file) != NULL) {
        char *cells[CELLS + 2];
        if (strncmp(line, "| ", 2) != 0 || line[2] == '|') {
            continue;
        }
        assert_int_equal(split(line, cells, CELLS + 2), CELLS + 1); /* and the line's end */
        assert_int_equal(atoi(cells[0]), ++claims);
        for (int i = 1; i < CELLS; i++) {
            assert_true(strlen(cells[i]) > 8);
            assert_null(strstr(cells[i], "nan"));
            assert_null(strstr(cells[i], "inf"));
        }
        assert_true(strcmp(cells[4], " **holds** ") == 0 ||
                    strcmp(cells[4], " **holds in part** ") == 0 ||
                    strcmp(cells[4], " **does not hold** ") == 0);
        /* The one claim that does not depend on the size. */
        assert_true(claims != 9 || strcmp(cells[4], " **holds** ") == 0);
    }
    (void)fclose(file);
    assert_int_equal(claims, PAPER_CLAIMS);
}

static void the_page_shows_all_of_it(void **state) {
    (void)state;
    const char *page = text_of("made/index.html");
    for (int i = 0; paper_figures[i].file != NULL; i++) {
        char image[128];
        (void)snprintf(image, sizeof image, "<img src=\"%s.png\"", paper_figures[i].file);
        assert_non_null(strstr(page, image));
    }
    int rows = 0;
    for (const char *at = page; (at = strstr(at, "<tr>")) != NULL; at++) {
        rows++;
    }
    assert_int_equal(rows, PAPER_CLAIMS + 1);
    assert_non_null(strstr(page, "</html>\n"));
    assert_status("grep -o 'src=\"[^\"]*\"' made/index.html | cut -d '\"' -f 2 | while read f; do "
                  "test -s made/$f || exit 9; done",
                  0);
}

/* The same counts as render's own statistics. */
static void curves_are_counts(void **state) {
    (void)state;
    assert_status("wc -l < made/fig7.csv", 0);
    assert_int_equal(atoi(text_of("out")), 1 + PAPER_DEPTHS);
    assert_status("awk -F, 'NF != 9 || (NR > 1 && $1 != NR - 2) { exit 9 }' made/fig7.csv", 0);
    assert_status("for n in 0 7 16; do "
                  "$SUPERFRAME render fig5 --depth $n --size 32x20 --stats - -o /dev/null | "
                  "awk -F '[ ,]+' '/\"rays\"|\"shadow_rays\"/ { rays += $3 } "
                  "/\"solid_tests\"/ { tests = $3 } END { print rays \",\" tests }' > expected; "
                  "awk -F, -v n=$n '$1 == n && NR > 1 { print $8 \",\" $9 }' made/fig7.csv | "
                  "cmp - expected || exit 9; done",
                  0);
}

/* In a folder that is there already, and without gnuplot. */
static void a_folder_that_is_there_keeps_its_other_files(void **state) {
    (void)state;
    assert_status("mkdir there && echo mine > there/mine && echo old > there/fig3b.png && "
                  "PATH=/nowhere " PAPER_RUN "-o there",
                  0);
    assert_non_null(strstr(text_of("err"), "superframe: gnuplot is not there"));
    assert_non_null(strstr(text_of("err"), "gnuplot-nox"));
    assert_status("cmp there/fig3b.png made/fig3b.png && cmp there/fig7.csv made/fig7.csv && "
                  "cmp there/fig7.gp made/fig7.gp",
                  0);
    assert_string_equal(text_of("there/mine"), "mine\n");
    assert_status("ls -A there | grep -c tmp", 1);
    assert_false(is_there("there/fig7-rays.png"));
    assert_status("grep -q 'img src=\"fig7-rays' there/index.html", 1);
}

/* Claim 1 is measured within the inner cube's outline, which fills some of the picture. */
static void the_first_claim_is_about_the_inner_cube(void **state) {
    (void)state;
    assert_status("$SUPERFRAME paper --quiet --size 80x50 -o claims", 0);
    const char *text = strstr(text_of("claims/claims.md"), "is measured on the ");
    unsigned pixels = 0;
    assert_non_null(text);
    assert_int_equal(sscanf(text, "is measured on the %u pixels", &pixels), 1);
    assert_in_range(pixels, 80 * 50 / 100, 80 * 50 / 10);
    assert_status("rm -r claims", 0);
}

/* ---- Where it fails ------------------------------------------------------------------------- */

static const struct {
    const char *line;
    int status;
    const char *fragment;
} wrong[] = {
    {"echo > file; " PAPER_RUN "-o file", 1, "superframe: file: cannot be written: Not a dir"},
    {"echo > file; " PAPER_RUN "-o file/x", 1, "superframe: file/x: cannot be written: Not a dir"},
    {PAPER_RUN "-o no/x", 1, "superframe: no/x: cannot be written: No such file"},
    {PAPER_RUN "-o /proc/x", 1, "superframe: /proc/x: cannot be written: "},
    {"ulimit -f 1; " PAPER_RUN "-o x", 1, "cannot be written: File too large"},
    {"$SUPERFRAME paper", 2, "superframe: paper: -o FOLDER is missing"},
    {"$SUPERFRAME paper -o x --size 321x200", 2, "superframe: --size: \"321x200\" is invalid"},
    {"$SUPERFRAME paper -o x --size 32x201", 2, "superframe: --size: \"32x201\" is invalid"},
};

static void failures_leave_nothing(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_status("rm -rf file x; mkdir empty; cd empty; ls -A", 0);
        char line[512];
        (void)snprintf(line, sizeof line, "cd empty; %s", wrong[i].line);
        assert_status(line, wrong[i].status);
        if (strstr(text_of("err"), wrong[i].fragment) == NULL) {
            fail_msg("\"%s\": \"%s\" lacks \"%s\"", wrong[i].line, text_of("err"),
                     wrong[i].fragment);
        }
        assert_status("cd empty; rm -f file; cd ..; rmdir empty", 0);
    }
}

/* timeout(1) without --foreground sends its signal twice: to the program and to its group. */
static void an_interrupted_run_leaves_nothing(void **state) {
    (void)state;
    assert_status("mkdir empty; cd empty; "
                  "timeout --preserve-status -s INT -k 60 2 $SUPERFRAME paper -o x",
                  130);
    assert_non_null(strstr(text_of("err"), "superframe: interrupted"));
    assert_status("rmdir empty", 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_figure_is_there),
        cmocka_unit_test(figures_are_renders),
        cmocka_unit_test(the_contact_sheet_has_every_figure_at_half_its_size),
        cmocka_unit_test(nine_claims_each_with_a_verdict),
        cmocka_unit_test(the_page_shows_all_of_it),
        cmocka_unit_test(curves_are_counts),
        cmocka_unit_test(a_folder_that_is_there_keeps_its_other_files),
        cmocka_unit_test(the_first_claim_is_about_the_inner_cube),
        cmocka_unit_test(failures_leave_nothing),
        cmocka_unit_test(an_interrupted_run_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
