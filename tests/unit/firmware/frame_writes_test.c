/* SPDX-License-Identifier: MIT */
/* What a frame costs in port writes: X once a dot, Y once a line, each primary once a dot. */
#include "scene_fixture.h"

#include "bus.h"

enum { SCREEN_WIDTH = 640, SCREEN_HEIGHT = 400 };

/* Counts what goes to each port, and how often each dot of the screen gets its blue, the last. */
struct counting_bus {
    struct bus bus;
    uint32_t writes[16], reads;
    uint16_t x, y;
    uint8_t drawn[SCREEN_HEIGHT][SCREEN_WIDTH];
    uint8_t rgb[3], shown[SCREEN_HEIGHT][SCREEN_WIDTH][3];
};

static void count_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct counting_bus *counting = (struct counting_bus *)bus;
    assert_true(port >= 0x00D0 && port <= 0x00DF);
    assert_int_equal(width, port == 0x00D4 || port == 0x00D6 ? BUS_WORD : BUS_BYTE);
    counting->writes[port - 0x00D0]++;
    switch (port) {
    case 0x00D4:
        counting->x = value;
        break;
    case 0x00D6:
        counting->y = value;
        break;
    case 0x00D8:
    case 0x00DA:
        counting->rgb[(port - 0x00D8) / 2] = (uint8_t)value;
        break;
    case 0x00DC:
        assert_true(counting->x < SCREEN_WIDTH && counting->y < SCREEN_HEIGHT);
        counting->rgb[2] = (uint8_t)value;
        counting->drawn[counting->y][counting->x]++;
        memcpy(counting->shown[counting->y][counting->x], counting->rgb, 3);
        break;
    default:
        break;
    }
}

static uint16_t count_read(struct bus *bus, uint16_t port, unsigned width) {
    (void)port;
    ((struct counting_bus *)bus)->reads++;
    return width == BUS_BYTE ? 0x00FF : 0xFFFF;
}

static const struct bus_operations counting_operations = {count_write, count_read, NULL};
static struct counting_bus counting;

static uint8_t test_level(unsigned x, unsigned y, unsigned primary) {
    return (uint8_t)(1 + (7 * x + 13 * y + 85 * primary) % 255);
}

static bool give_row(void *context, uint16_t y, uint8_t *rgb) {
    unsigned width = *(const unsigned *)context;
    for (unsigned x = 0; x < width; x++) {
        for (unsigned primary = 0; primary < 3; primary++) {
            *rgb++ = test_level(x, y, primary);
        }
    }
    return true;
}

/* Draws rows that nobody renders; everything on the screen has to be drawn once, and to be right.
 */
static void draw(unsigned width, unsigned height) {
    struct scene_error error;
    struct scene_description *description = load_scene("fig3", &error);
    assert_non_null(description);
    description->width = (int)width;
    description->height = (int)height;
    struct loaded_scene loaded = load_description(description, "fx");
    struct drawing drawing;
    memset(&drawing, 0, sizeof drawing);
    memset(&counting, 0, sizeof counting);
    counting.bus.operations = &counting_operations;
    drawing.base = 0x00D0;
    drawing.last = (uint16_t)height;
    drawing.source = give_row;
    drawing.context = &width;
    bus_bind(&counting.bus);
    loaded.arithmetic->image->draw(loaded.scene, &drawing);
    bus_bind(NULL);
    unload(&loaded);
    scene_description_free(description);
    unsigned dots = width <= 320 && height <= 200 ? 2 : 1;
    for (unsigned y = 0; y < SCREEN_HEIGHT; y++) {
        for (unsigned x = 0; x < SCREEN_WIDTH; x++) {
            bool within = x < width * dots && y < height * dots;
            assert_int_equal(counting.drawn[y][x], 1);
            for (unsigned primary = 0; primary < 3; primary++) {
                assert_int_equal(counting.shown[y][x][primary],
                                 within ? test_level(x / dots, y / dots, primary) : 0);
            }
        }
    }
}

static void a_full_frame_takes_four_writes_a_dot_and_one_a_line(void **state) {
    (void)state;
    draw(640, 400);
    assert_int_equal(counting.writes[0x4], 640 * 400);
    assert_int_equal(counting.writes[0x6], 400);
    assert_int_equal(counting.writes[0x8], 640 * 400);
    assert_int_equal(counting.writes[0xA], 640 * 400);
    assert_int_equal(counting.writes[0xC], 640 * 400);
    uint32_t all = 0;
    for (int i = 0; i < 16; i++) {
        all += counting.writes[i];
    }
    /* What is left starts the board: 4.0018 writes a pixel at most. */
    assert_true(all - 4 * 640 * 400 - 400 <= 64);
    assert_int_equal(counting.reads, 0);
}

static void every_dot_is_drawn_once_whatever_the_size(void **state) {
    (void)state;
    static const unsigned sizes[][2] = {{1, 1},     {639, 399}, {320, 200}, {319, 199},
                                        {321, 200}, {320, 201}, {640, 1},   {1, 400}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        draw(sizes[i][0], sizes[i][1]);
        assert_int_equal(counting.writes[0x4], 640 * 400);
        assert_int_equal(counting.writes[0x6], 400);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_full_frame_takes_four_writes_a_dot_and_one_a_line),
        cmocka_unit_test(every_dot_is_drawn_once_whatever_the_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
