/* SPDX-License-Identifier: MIT */
/* Floppies in files: three formats are read, the others are named. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boot/disk_image.h"

enum { D88_TRACK = 8 * (16 + 1024), D88_MOST = 0x2B0 + 154 * D88_TRACK };

static uint8_t file[2 * D88_MOST];
static struct pc98_disk disk;
static char reason[240];

static void put(size_t at, uint32_t value, unsigned bytes) {
    for (unsigned i = 0; i < bytes; i++) {
        file[at + i] = (uint8_t)(value >> 8 * i);
    }
}

/* Returns what every byte of a sector is, by its number over the whole disk. */
static uint8_t content(unsigned sector) {
    return (uint8_t)(sector * 7 + 1 + sector / 256);
}

static bool read_file(size_t count) {
    memset(&disk, 0, sizeof disk);
    reason[0] = '\0';
    return disk_image_read(file, count, &disk, reason, sizeof reason);
}

static void expect_refusal(size_t count, const char *text) {
    assert_false(read_file(count));
    if (strstr(reason, text) == NULL) {
        fail_msg("\"%s\" does not say \"%s\"", reason, text);
    }
}

static void expect_disk(void) {
    for (unsigned i = 0; i < PC98_DISK_SECTORS; i++) {
        assert_int_equal(disk.bytes[i * 1024U], content(i));
        assert_int_equal(disk.bytes[i * 1024U + 1023], content(i));
        assert_int_equal(disk.status[i], DISK_DONE);
    }
}

/* Returns where a sector's header lies in a D88; sectors of a track are recorded from the last to
 * the first. */
static size_t d88_sector(size_t header, unsigned sector) {
    return header + sector / 8 * D88_TRACK + (7 - sector % 8) * (16 + 1024);
}

/* Makes a whole D88 of a 2HD disk; returns its size. */
static size_t make_d88(size_t header) {
    memset(file, 0, sizeof file);
    memcpy(file, "a disk", 6);
    file[0x1B] = 0x20;
    for (unsigned track = 0; track < 154; track++) {
        put(0x20 + 4 * track, (uint32_t)(header + track * D88_TRACK), 4);
    }
    for (unsigned i = 0; i < PC98_DISK_SECTORS; i++) {
        size_t at = d88_sector(header, i);
        const uint8_t address[] = {(uint8_t)(i / 16), (uint8_t)(i / 8 % 2), (uint8_t)(1 + i % 8),
                                   3};
        memcpy(file + at, address, sizeof address);
        put(at + 4, 8, 2);
        put(at + 14, 1024, 2);
        memset(file + at + 16, content(i), 1024);
    }
    size_t size = header + 154 * D88_TRACK;
    put(0x1C, (uint32_t)size, 4);
    return size;
}

/* Makes an FDI; returns its size. */
static size_t make_fdi(size_t header, uint32_t type) {
    const uint32_t numbers[] = {0, type, (uint32_t)header, PC98_DISK_BYTES, 1024, 8, 2, 77};
    memset(file, 0xFF, sizeof file);
    for (unsigned i = 0; i < 8; i++) {
        put(4 * i, numbers[i], 4);
    }
    for (unsigned i = 0; i < PC98_DISK_SECTORS; i++) {
        memset(file + header + i * 1024U, content(i), 1024);
    }
    return header + PC98_DISK_BYTES;
}

static void a_raw_image_is_read(void **state) {
    (void)state;
    memset(file, 0xFF, sizeof file);
    for (unsigned i = 0; i < PC98_DISK_SECTORS; i++) {
        memset(file + i * 1024U, content(i), 1024);
    }
    assert_true(read_file(PC98_DISK_BYTES));
    expect_disk();
    assert_false(disk.is_protected);
    expect_refusal(PC98_DISK_BYTES - 1, "no 2HD image: less than 1261568 bytes");
    expect_refusal(PC98_DISK_BYTES + 1, "no 2HD image: more than 1261568 bytes");
    expect_refusal(0, "no 2HD image: less than 1261568 bytes");
}

static void a_d88_with_either_header_is_read(void **state) {
    (void)state;
    static const size_t headers[] = {688, 672};
    for (unsigned i = 0; i < 2; i++) {
        size_t size = make_d88(headers[i]);
        assert_true(read_file(size));
        expect_disk();
        assert_false(disk.is_protected);
        file[0x1A] = 0x10;
        assert_true(read_file(size));
        assert_true(disk.is_protected);
    }
}

static void of_several_disks_in_a_d88_the_first_is_read(void **state) {
    (void)state;
    size_t size = make_d88(688);
    memcpy(file + size, file, 688);
    assert_true(read_file(2 * size));
    expect_disk();
}

static void sectors_that_a_d88_lacks_are_missing_on_the_disk(void **state) {
    (void)state;
    size_t size = make_d88(688);
    put(0x20 + 4 * 3, 0, 4);             /* cylinder 1, head 1 is not formatted */
    file[d88_sector(688, 8) + 8] = 0xB0; /* a wrong checksum */
    for (unsigned i = 16; i < 24; i++) { /* cylinder 1, head 0 without its sector 1 */
        put(d88_sector(688, i) + 4, 7, 2);
    }
    assert_true(read_file(size));
    assert_int_equal(disk.status[8], DISK_DATA_ERROR);
    assert_int_equal(disk.status[16], DISK_NO_SECTOR);
    assert_int_equal(disk.status[17], DISK_DONE);
    for (unsigned i = 24; i < 32; i++) {
        assert_int_equal(disk.status[i], DISK_NO_ADDRESS_MARK);
    }
    file[d88_sector(688, 0) + 8] = 0xB0;
    expect_refusal(size, "its first sector is missing or damaged");
}

static void other_d88s_are_refused(void **state) {
    (void)state;
    size_t size = make_d88(688);
    expect_refusal(size - 1, "cylinder 76, head 1 is past the end of the file");
    expect_refusal(700, "cylinder 0, head 0 is past the end of the file");
    file[0x1B] = 0x10;
    expect_refusal(size, "a D88 image of another disk than a 2HD one (medium 10h)");
    static const struct {
        size_t offset;
        uint8_t value;
    } changes[] = {{0, 2}, {1, 0}, {2, 9}, {2, 0}, {3, 2}, {6, 0x40}, {14, 1}};
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        size = make_d88(688);
        file[d88_sector(688, 30) + changes[i].offset] = changes[i].value;
        expect_refusal(size, "cylinder 1, head 1 has sectors of another format");
    }
    size = make_d88(688);
    put(0x20 + 4 * 5, 0xFFFFFFF0, 4);
    expect_refusal(size, "cylinder 2, head 1 is past the end of the file");
}

static void an_fdi_is_read_behind_the_header_that_it_names(void **state) {
    (void)state;
    static const size_t headers[] = {4096, 32, 8192};
    for (unsigned i = 0; i < 3; i++) {
        size_t size = make_fdi(headers[i], 0x90);
        assert_true(read_file(size));
        expect_disk();
        expect_refusal(size - 1, "an FDI image that ends too early");
    }
    size_t size = make_fdi(4096, 0x30);
    put(0x0C, 80 * 2 * 18 * 512, 4);
    put(0x10, 512, 4);
    put(0x14, 18, 4);
    put(0x1C, 80, 4);
    expect_refusal(size, "an FDI image of 80 x 2 x 18 sectors of 512 bytes");
    put(0x0C, 615 * 8 * 33 * 256, 4);
    put(0x10, 256, 4);
    put(0x14, 33, 4);
    put(0x18, 8, 4);
    put(0x1C, 615, 4);
    expect_refusal(size, "an HDI image");
    put(0x0C, 80 * 8 * 33 * 256, 4); /* few cylinders, and more heads than a floppy has */
    put(0x1C, 80, 4);
    expect_refusal(size, "an HDI image");
    put(0x0C, 1, 4); /* numbers that do not agree */
    expect_refusal(size, "no 2HD image");
}

static void other_formats_are_named(void **state) {
    static const struct {
        size_t offset;
        const char *text, *name;
    } known[] = {{0, "T98FDDIMAGE.R0", "an NFD image"}, {0, "T98FDDIMAGE.R1", "an NFD image"},
                 {0, "T98HDDIMAGE.R0", "an NHD image"}, {0, "VFD1.00", "a VFD image"},
                 {0, "VHD1.00", "a VHD image"},         {0, "IMD 1.18", "an ImageDisk image"},
                 {0, "HXCPICFE", "an HFE image"},       {0, "SCP", "an SCP image"},
                 {0, "PK\003\004", "a ZIP archive"},    {0, "\037\213", "a gzip file"},
                 {0, "7z\274\257", "a 7z archive"},     {0, "Rar!", "a RAR archive"},
                 {2, "-lh5-", "an LHA archive"}};
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        memset(file, 0xFF, sizeof file);
        memcpy(file + known[i].offset, known[i].text, strlen(known[i].text));
        expect_refusal(300000, known[i].name);
        expect_refusal(strlen(known[i].text) + known[i].offset, known[i].name);
    }
    memset(file, 0xFF, sizeof file);
    memset(file, 1, 162);
    expect_refusal(162 + 154 * 8192, "a DCP image");
    expect_refusal(162 + 154 * 8192, "Virtual Floppy Image Converter");
    file[100] = 2;
    expect_refusal(162 + 154 * 8192, "no 2HD image: more");
    memset(file, 0, sizeof file);
    expect_refusal(1474560, "a raw image of 1.44 MB");
    expect_refusal(1228800, "a raw image of 1.2 MB");
    expect_refusal(737280, "a raw image of 720 KB");
    expect_refusal(655360, "a raw image of 640 KB");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_raw_image_is_read),
        cmocka_unit_test(a_d88_with_either_header_is_read),
        cmocka_unit_test(of_several_disks_in_a_d88_the_first_is_read),
        cmocka_unit_test(sectors_that_a_d88_lacks_are_missing_on_the_disk),
        cmocka_unit_test(other_d88s_are_refused),
        cmocka_unit_test(an_fdi_is_read_behind_the_header_that_it_names),
        cmocka_unit_test(other_formats_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
