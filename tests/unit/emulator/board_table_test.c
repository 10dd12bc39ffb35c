/* SPDX-License-Identifier: MIT */
/* Reads the table of accesses in docs/board.md and drives the emulator by it, through ports. */
#include "board_fixture.h"

#include "picture.h"

enum { REGISTERS = 8, ROWS = REGISTERS * 8, CELL_SIZE = 32, SEED = 7 };

/* Where the board stands before an access under test. */
enum { START_X = 0x0164, START_Y = 0x0084, VALUE_BYTE = 0x02, VALUE_WORD = 0x0102 };

/* One row of the table. */
struct row {
    char name[CELL_SIZE];
    unsigned number; /* of the register: 0..7 */
    unsigned width;
    bool is_odd, is_read;
    char effect[BOARD_PROFILES][CELL_SIZE];
    char grade[BOARD_PROFILES][CELL_SIZE];
};

static struct row rows[ROWS];
static unsigned row_count;

static const char *const register_names[REGISTERS] = {"control 1", "control 2", "X",    "Y",
                                                      "red",       "green",     "blue", "mode"};

/* ---- Reading the table ---------------------------------------------------------------------- */

/* Takes the text up to the next bar, trimmed; an empty cell is a failure. */
static const char *take_cell(const char *text, char cell[CELL_SIZE]) {
    const char *end = strchr(text, '|');
    if (end == NULL) {
        fail_msg("a row has too few cells: %s", text);
        return text;
    }
    const char *last = end;
    while (*text == ' ') {
        text++;
    }
    while (last > text && last[-1] == ' ') {
        last--;
    }
    size_t length = (size_t)(last - text);
    if (last <= text || length >= CELL_SIZE) {
        fail_msg("a cell is empty or too long: %s", text);
    }
    memcpy(cell, text, length);
    cell[length] = '\0';
    return end + 1;
}

static unsigned choose(const char *cell, const char *first, const char *second) {
    if (strcmp(cell, first) != 0 && strcmp(cell, second) != 0) {
        fail_msg("'%s' is neither %s nor %s", cell, first, second);
    }
    return strcmp(cell, second) == 0 ? 1 : 0;
}

static void parse_row(const char *line, struct row *row) {
    char cell[CELL_SIZE];
    const char *text = take_cell(line + 1, row->name);
    row->number = 0;
    while (row->number < REGISTERS && strcmp(row->name, register_names[row->number]) != 0) {
        row->number++;
    }
    assert_in_range(row->number, 0, REGISTERS - 1);
    text = take_cell(text, cell);
    row->width = choose(cell, "byte", "word") + 1;
    text = take_cell(text, cell);
    row->is_odd = choose(cell, "even", "odd") == 1;
    text = take_cell(text, cell);
    row->is_read = choose(cell, "write", "read") == 1;
    for (unsigned profile = 0; profile < BOARD_PROFILES; profile++) {
        text = take_cell(text, row->effect[profile]);
        text = take_cell(text, row->grade[profile]);
    }
}

static int read_table(void **state) {
    char line[512];
    bool is_table = false;
    FILE *file = fopen("docs/board.md", "r");
    (void)state;
    if (file == NULL) {
        print_error("docs/board.md can't be opened; run the tests from the project's folder\n");
        return -1;
    }
    while (fgets(line, sizeof line, file) != NULL) {
        if (strstr(line, "board_table_test.c reads this table") != NULL) {
            is_table = true;
        } else if (is_table && line[0] == '|' && strncmp(line, "| register", 10) != 0 &&
                   strncmp(line, "|---", 4) != 0 && row_count < ROWS) {
            parse_row(line, &rows[row_count++]);
        } else if (is_table && row_count > 0) {
            break;
        }
    }
    fclose(file);
    return 0;
}

static void every_access_of_every_register_has_one_row(void **state) {
    bool is_seen[REGISTERS][2][2][2] = {{{{false}}}};
    (void)state;
    assert_int_equal(row_count, ROWS);
    for (unsigned i = 0; i < row_count; i++) {
        bool *seen = &is_seen[rows[i].number][rows[i].width - 1][rows[i].is_odd][rows[i].is_read];
        assert_false(*seen);
        *seen = true;
    }
}

/* ---- Seeing what an access did, by ports and by the screen ---------------------------------- */

/* What ports and screen show. */
struct view {
    unsigned rgb;    /* at X, Y as they are */
    uint8_t data;    /* of the index as it is */
    bool is_showing; /* the board's picture is on the screen */
};

static bool picture_is_showing(void) {
    static uint8_t rgb[PICTURE_BYTES];
    picture_draw(&board, NULL, rgb);
    for (size_t i = 0; i < 300; i++) {
        if (rgb[i] != 0) {
            return true;
        }
    }
    return false;
}

static struct view look(void) {
    struct view view = {get_here(), inp(0x00D2), picture_is_showing()};
    return view;
}

static bool is_same_view(struct view a, struct view b) {
    return a.rgb == b.rgb && a.data == b.data && a.is_showing == b.is_showing;
}

/* A board full of noise, initialised; index 06 selected, mode 00, at the starting place. */
static void prepare(enum board_profile profile) {
    power_on_noise(profile, SEED);
    initialise();
    outp(0x00D0, 0x06);
    go_to(START_X, START_Y);
}

/* The noise at a place, of a board of its own, so that nothing under test has touched it. */
static unsigned noise_at(unsigned x, unsigned y) {
    static struct board fresh;
    struct board_desc desc = board_default_desc(BOARD_LATER);
    struct board_bus fresh_bus;
    desc.noise = true;
    desc.noise_seed = SEED;
    assert_true(board_init(&fresh, &desc));
    board_bus_init(&fresh_bus, &fresh);
    struct bus *before = bus_bind(&fresh_bus.bus);
    unsigned rgb = get_pixel(x, y);
    bus_bind(before);
    return rgb;
}

static uint16_t access_port(const struct row *row) {
    return (uint16_t)(0x00D0 + row->number * 2 + (row->is_odd ? 1 : 0));
}

static uint16_t make_access(const struct row *row, unsigned value) {
    uint16_t port = access_port(row);
    if (row->is_read) {
        return row->width == 1 ? inp(port) : inpw(port);
    }
    if (row->width == 1) {
        outp(port, (uint8_t)value);
    } else {
        outpw(port, (uint16_t)value);
    }
    return 0;
}

static void check(const struct row *row, const char *effect, bool holds) {
    if (!holds) {
        fail_msg("%s, %s, %s port, %s: not '%s'", row->name, row->width == 1 ? "byte" : "word",
                 row->is_odd ? "odd" : "even", row->is_read ? "read" : "write", effect);
    }
}

/* ---- Each effect ---------------------------------------------------------------------------- */

static unsigned primary_of(const struct row *row, unsigned rgb) {
    return rgb >> (16 - 8 * (row->number - 4)) & 0xFF;
}

/* X or Y after the access must be `expected`: the noise there is what the ports show. */
static bool position_is(const struct row *row, unsigned expected) {
    unsigned x = row->number == 2 ? expected : START_X;
    unsigned y = row->number == 3 ? expected : START_Y;
    return look().rgb == noise_at(x, y);
}

static bool fill_holds(const struct row *row) {
    make_access(row, 0x0000);
    bool holds = get_pixel(START_X - 1, START_Y) == noise_at(START_X - 1, START_Y) &&
                 get_pixel(START_X + 4, START_Y) == noise_at(START_X + 4, START_Y);
    for (unsigned i = 0; i < 4; i++) {
        holds = holds && get_pixel(START_X + i, START_Y) == 0;
    }
    return holds;
}

static bool primary_write_holds(const struct row *row, unsigned value) {
    unsigned shift = 16 - 8 * (row->number - 4);
    unsigned expected = (noise_at(START_X, START_Y) & ~(0xFFU << shift)) | (value & 0xFF) << shift;
    make_access(row, value);
    return get_here() == expected &&
           get_pixel(START_X + 1, START_Y) == noise_at(START_X + 1, START_Y);
}

static bool write_holds(const struct row *row, const char *effect) {
    unsigned value = row->width == 1 ? VALUE_BYTE : VALUE_WORD;
    unsigned position = row->number == 2 ? START_X : START_Y;
    struct view before = look();
    if (strcmp(effect, "fill") == 0) {
        return fill_holds(row);
    }
    if (strcmp(effect, "primary") == 0) {
        return primary_write_holds(row, value);
    }
    if (strcmp(effect, "mode") == 0) {
        make_access(row, 0x0201); /* 01: both pictures */
        return !before.is_showing && look().is_showing;
    }
    make_access(row, value);
    if (strcmp(effect, "nothing") == 0) {
        return is_same_view(look(), before);
    }
    if (strcmp(effect, "index") == 0) {
        return before.data == 0x19 && look().data == 0x5B; /* index 02 holds 5B */
    }
    if (strcmp(effect, "data") == 0) {
        return look().data == (value & 0xFF);
    }
    if (strcmp(effect, "position") == 0) {
        return position_is(row, value);
    }
    if (strcmp(effect, "low byte") == 0) {
        return position_is(row, (position & 0xFF00) | value);
    }
    if (strcmp(effect, "high bits") == 0) {
        unsigned mask = row->number == 2 ? 0x3FF : 0x1FF;
        return position_is(row, ((value << 8) | (position & 0xFF)) & mask);
    }
    fail_msg("the effect '%s' is none that a write can have", effect);
    return false;
}

static bool read_holds(const struct row *row, const char *effect) {
    struct view before = look();
    uint16_t answer = make_access(row, 0);
    if (!is_same_view(look(), before)) {
        return false; /* no read changes anything */
    }
    if (strcmp(effect, "data") == 0) {
        return answer == 0x19;
    }
    if (strcmp(effect, "FF data") == 0) {
        return answer == 0xFF19;
    }
    if (strcmp(effect, "primary") == 0) {
        return answer == primary_of(row, before.rgb);
    }
    if (strcmp(effect, "FF primary") == 0) {
        return answer == (0xFF00 | primary_of(row, before.rgb));
    }
    unsigned expected = 0;
    char rest;
    if (strlen(effect) != row->width * 2 || sscanf(effect, "%x%c", &expected, &rest) != 1) {
        fail_msg("the effect '%s' is none that a read can have", effect);
    }
    return answer == expected;
}

/* A word at an odd port against the two byte accesses on a second board. */
static bool two_bytes_hold(const struct row *row, enum board_profile profile) {
    uint16_t port = access_port(row);
    uint16_t answer = make_access(row, 0x0301);
    struct view as_word = look();
    uint64_t violations = board_violations(&board);
    prepare(profile);
    uint16_t as_bytes = 0;
    if (row->is_read) {
        unsigned low = inp(port);
        as_bytes = (uint16_t)(low | (unsigned)inp((uint16_t)(port + 1)) << 8);
    } else {
        outp(port, 0x01);
        outp((uint16_t)(port + 1), 0x03);
    }
    return answer == as_bytes && is_same_view(look(), as_word) &&
           board_violations(&board) == violations;
}

/* ---- The tests ------------------------------------------------------------------------------ */

static void check_effects(enum board_profile profile) {
    for (unsigned i = 0; i < row_count; i++) {
        const struct row *row = &rows[i];
        const char *effect = row->effect[profile];
        prepare(profile);
        if (strcmp(effect, "two bytes") == 0) {
            check(row, effect, two_bytes_hold(row, profile));
        } else {
            check(row, effect, row->is_read ? read_holds(row, effect) : write_holds(row, effect));
        }
    }
}

/* The grade of a row is the worst that its access relies on; `!` says that it is reported. */
static void check_grades(enum board_profile profile) {
    static const char letters[] = "PDSIA";
    for (unsigned i = 0; i < row_count; i++) {
        const struct row *row = &rows[i];
        char found[CELL_SIZE];
        prepare(profile);
        uint64_t before[5];
        for (int grade = 0; grade < 5; grade++) {
            before[grade] = board_reliances(&board, (enum board_grade)grade);
        }
        uint64_t violations = board_violations(&board);
        make_access(row, 0x0000);
        int worst = 4;
        while (worst > 0 && board_reliances(&board, (enum board_grade)worst) == before[worst]) {
            worst--;
        }
        snprintf(found, sizeof found, "%c%s", letters[worst],
                 board_violations(&board) > violations ? " !" : "");
        if (strcmp(found, row->grade[profile]) != 0) {
            print_error("found %s, the table says %s\n", found, row->grade[profile]);
            check(row, row->effect[profile], false);
        }
    }
}

static void the_1987_board_does_what_the_table_says(void **state) {
    (void)state;
    check_effects(BOARD_1987);
}

static void the_later_board_does_what_the_table_says(void **state) {
    (void)state;
    check_effects(BOARD_LATER);
}

static void the_1987_board_has_the_grades_of_the_table(void **state) {
    (void)state;
    check_grades(BOARD_1987);
}

static void the_later_board_has_the_grades_of_the_table(void **state) {
    (void)state;
    check_grades(BOARD_LATER);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_access_of_every_register_has_one_row),
        cmocka_unit_test(the_1987_board_does_what_the_table_says),
        cmocka_unit_test(the_later_board_does_what_the_table_says),
        cmocka_unit_test(the_1987_board_has_the_grades_of_the_table),
        cmocka_unit_test(the_later_board_has_the_grades_of_the_table),
    };
    return cmocka_run_group_tests(tests, read_table, NULL);
}
