/* SPDX-License-Identifier: MIT */
/* The firmware starts the board as docs/board.md says, write by write. */
#include "scene_fixture.h"

#include "bus.h"

enum { WRITES_MOST = 64, VALUES_MOST = 4 };

/* One access: where from the base, what, and how wide. */
struct write {
    unsigned offset, value, width;
};

/* A bus that keeps what is written to it, and has no board. */
struct writes {
    struct bus bus;
    uint16_t base;
    unsigned count;
    struct write write[WRITES_MOST];
};

static void add_write(struct writes *writes, unsigned offset, unsigned value) {
    assert_true(writes->count < WRITES_MOST);
    writes->write[writes->count++] = (struct write){offset, value, BUS_BYTE};
}

static void keep_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct writes *writes = (struct writes *)bus;
    add_write(writes, (uint16_t)(port - writes->base), value);
    writes->write[writes->count - 1].width = width;
}

static uint16_t refuse_read(struct bus *bus, uint16_t port, unsigned width) {
    (void)bus;
    fail_msg("port %04X is read, %u bytes", (unsigned)port, width);
    return 0xFFFF;
}

/* Takes the hexadecimal bytes of a table's cell, "0C, 0D"; returns how many there are, 0 if it
 * holds anything else. */
static unsigned take_bytes(const char *cell, unsigned value[VALUES_MOST]) {
    unsigned count = 0;
    int used = 0;
    while (count < VALUES_MOST && sscanf(cell, " %2x%n", &value[count], &used) == 1) {
        cell += used;
        count++;
        if (*cell != ',') {
            break;
        }
        cell++;
    }
    return cell[strspn(cell, " ")] == '|' ? count : 0;
}

/* Returns where the cell of that number begins in a table's row; NULL if there is none. */
static const char *cell_of(const char *line, int number) {
    for (; line != NULL && number > 0; number--) {
        line = strchr(line + 1, '|');
    }
    return line != NULL ? line + 1 : NULL;
}

/* Adds the writes of a row | index | meaning | initialised to |; returns how many pairs it holds.
 */
static unsigned add_row(struct writes *writes, const char *line) {
    unsigned index[VALUES_MOST], data[VALUES_MOST];
    const char *initialised = cell_of(line, 2);
    unsigned count = take_bytes(cell_of(line, 0), index);
    if (count == 0 || initialised == NULL || strncmp(initialised, " – ", 5) == 0) {
        return 0;
    }
    if (take_bytes(initialised, data) != count) {
        fail_msg("not as many values as indices: %s", line);
    }
    for (unsigned i = 0; i < count; i++) {
        add_write(writes, 0x0, index[i]);
        add_write(writes, 0x2, data[i]);
    }
    return count;
}

/* Reads the page's table of the controller, and what its text says of the mode. */
static void read_page(struct writes *writes) {
    char line[512];
    bool is_table = false;
    unsigned pairs = 0;
    FILE *file = fopen("docs/board.md", "r");
    assert_non_null(file);
    memset(writes, 0, sizeof *writes);
    while (fgets(line, sizeof line, file) != NULL) {
        is_table = is_table || strncmp(line, "| index | meaning | initialised to |", 36) == 0;
        if (is_table && line[0] != '|') {
            break;
        }
        pairs += is_table ? add_row(writes, line) : 0;
    }
    (void)fclose(file);
    assert_int_equal(pairs, 15); /* "all fifteen indices" */
    add_write(writes, 0xE, 0x00);
    add_write(writes, 0xE, 0x01);
}

static bool give_no_row(void *context, uint16_t y, uint8_t *rgb) {
    (void)context;
    (void)y;
    (void)rgb;
    return false;
}

/* Draws nothing but the start of the board. */
static void start(struct writes *writes, uint16_t base, const char *arithmetic) {
    static const struct bus_operations operations = {keep_write, refuse_read, NULL};
    const struct drawing drawing = {.base = base, .last = 1, .source = give_no_row};
    struct scene_error error;
    struct scene_description *description = load_scene("fig3", &error);
    assert_non_null(description);
    struct loaded_scene loaded = load_description(description, arithmetic);
    memset(writes, 0, sizeof *writes);
    writes->bus.operations = &operations;
    writes->base = base;
    (void)bus_bind(&writes->bus);
    loaded.arithmetic->image->draw(loaded.scene, &drawing);
    (void)bus_bind(NULL);
    unload(&loaded);
    scene_description_free(description);
}

static void the_start_is_the_pages_to_the_last_write(void **state) {
    (void)state;
    static const uint16_t bases[] = {0x00D0, 0x02D0, 0x04D0, 0x06D0, 0x08D0, 0x0AD0, 0x0CD0};
    static struct writes page, firmware;
    read_page(&page);
    for (size_t i = 0; i < sizeof bases / sizeof bases[0]; i++) {
        start(&firmware, bases[i], i % 2 == 0 ? "fx" : "f64");
        for (unsigned j = 0; j < firmware.count && j < page.count; j++) {
            const struct write *wanted = &page.write[j], *found = &firmware.write[j];
            if (memcmp(wanted, found, sizeof *wanted) != 0) {
                fail_msg("base %04X, write %u is of %02X to offset %X, %u bytes; the page has %02X "
                         "to %X",
                         (unsigned)bases[i], j, found->value, found->offset, found->width,
                         wanted->value, wanted->offset);
            }
        }
        assert_int_equal(firmware.count, page.count);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_start_is_the_pages_to_the_last_write),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
