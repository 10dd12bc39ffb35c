/* SPDX-License-Identifier: MIT */
/* The disk BIOS: which bytes of the disk go where, and what is answered. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "boot/pc98_disk.h"

static struct pc98_disk disk;
static struct pc98_disk_call call;

/* Makes a disk whose sectors begin with their own number, counted from 0 over the whole disk. */
static int make_disk(void **state) {
    (void)state;
    memset(&disk, 0, sizeof disk);
    memset(&call, 0, sizeof call);
    for (unsigned i = 0; i < PC98_DISK_SECTORS; i++) {
        disk.bytes[i * 1024] = (uint8_t)i;
        disk.bytes[i * 1024 + 1] = (uint8_t)(i >> 8);
        disk.bytes[i * 1024 + 1023] = 0xEE;
    }
    return 0;
}

static enum pc98_disk_status serve(unsigned ah, unsigned cylinder, unsigned head, unsigned sector,
                                   unsigned bytes) {
    call.ah = (uint8_t)ah;
    call.al = 0x90;
    call.ch = 3;
    call.cl = (uint8_t)cylinder;
    call.dh = (uint8_t)head;
    call.dl = (uint8_t)sector;
    call.bx = (uint16_t)bytes;
    return pc98_disk_serve(&disk, &call);
}

/* Returns the number of the sector that lies at that place of the buffer. */
static unsigned number_at(unsigned sector) {
    return call.buffer[sector * 1024U] | (unsigned)call.buffer[sector * 1024U + 1] << 8;
}

static void each_sector_is_where_its_address_says(void **state) {
    (void)state;
    for (unsigned i = 0; i < PC98_DISK_SECTORS; i++) {
        assert_int_equal(serve(0x56, i / 16, i / 8 % 2, 1 + i % 8, 1024), DISK_DONE);
        assert_int_equal(number_at(0), i);
        assert_int_equal(call.buffer[1023], 0xEE);
        assert_int_equal(call.received, 1024);
    }
}

static void a_long_read_goes_on_in_the_track_and_by_mt_on_the_other_side(void **state) {
    (void)state;
    assert_int_equal(serve(0x56, 5, 1, 3, 6 * 1024), DISK_DONE);
    for (unsigned i = 0; i < 6; i++) {
        assert_int_equal(number_at(i), 5 * 16 + 8 + 2 + i);
    }
    assert_int_equal(serve(0xD6, 5, 0, 7, 10 * 1024), DISK_DONE);
    for (unsigned i = 0; i < 10; i++) {
        assert_int_equal(number_at(i), 5 * 16 + 6 + i);
    }
}

/* What came before the error is there, and nothing of what did not come. */
static void an_error_leaves_what_was_read_before(void **state) {
    (void)state;
    memset(call.buffer, 0x55, sizeof call.buffer);
    assert_int_equal(serve(0x56, 0, 0, 7, 3 * 1024), DISK_END_OF_CYLINDER);
    assert_int_equal(call.received, 2048);
    assert_int_equal(number_at(1), 7);
    assert_int_equal(call.buffer[2048], 0x55);
    disk.status[9] = DISK_DATA_ERROR;
    assert_int_equal(serve(0x56, 0, 1, 1, 3 * 1024), DISK_DATA_ERROR);
    assert_int_equal(call.received, 1024);
    assert_int_equal(serve(0x51, 0, 1, 1, 1024), DISK_DONE);
    assert_int_equal(call.received, 0);
    assert_int_equal(serve(0x51, 0, 1, 2, 1024), DISK_DATA_ERROR);
}

static void a_cut_sector_is_read_in_part_and_written_with_zeros(void **state) {
    (void)state;
    memset(call.buffer, 0x55, sizeof call.buffer);
    assert_int_equal(serve(0x56, 0, 0, 1, 1), DISK_DONE);
    assert_int_equal(call.buffer[1], 0x55);
    assert_int_equal(serve(0x55, 3, 0, 2, 1025), DISK_DONE);
    const uint8_t *written = disk.bytes + (3 * 16 + 1) * 1024;
    assert_int_equal(written[0], 0);
    assert_int_equal(written[1], 0x55);
    assert_int_equal(written[1024], 0x55);
    assert_int_equal(written[1025], 0);
    assert_int_equal(written[2047], 0);
    assert_int_equal(written[-1], 0xEE);
    assert_int_equal(written[2048], 3 * 16 + 3);
}

static void a_write_mends_a_sector_unless_the_disk_is_protected(void **state) {
    (void)state;
    disk.status[0] = DISK_DATA_ERROR;
    disk.is_protected = true;
    assert_int_equal(serve(0x55, 0, 0, 1, 1024), DISK_NOT_WRITABLE);
    assert_int_equal(serve(0x56, 0, 0, 1, 1024), DISK_DATA_ERROR);
    assert_int_equal(serve(0x04, 0, 0, 0, 0), 0x11);
    disk.is_protected = false;
    assert_int_equal(serve(0x55, 0, 0, 1, 1024), DISK_DONE);
    assert_int_equal(serve(0x56, 0, 0, 1, 1024), DISK_DONE);
    assert_int_equal(serve(0x04, 0, 0, 0, 0), 0x01);
}

/* The border lies where the low 16 bits of the address begin anew; a verify transfers nothing. */
static void a_transfer_may_end_at_a_border_and_not_cross_it(void **state) {
    (void)state;
    call.address = 0x3FC00;
    assert_int_equal(serve(0x56, 0, 0, 1, 1024), DISK_DONE);
    assert_int_equal(serve(0x56, 0, 0, 1, 1025), DISK_BORDER);
    assert_int_equal(call.received, 0);
    assert_int_equal(serve(0x55, 0, 0, 1, 1025), DISK_BORDER);
    assert_int_equal(serve(0x51, 0, 0, 1, 1025), DISK_DONE);
    call.address = 0x40000;
    assert_int_equal(serve(0x56, 0, 0, 1, 8192), DISK_DONE);
}

static void what_is_no_sector_is_not_found(void **state) {
    (void)state;
    assert_int_equal(serve(0x56, 0, 0, 0, 1024), DISK_NO_SECTOR);
    assert_int_equal(serve(0x56, 0, 0, 9, 1024), DISK_NO_SECTOR);
    assert_int_equal(serve(0x56, 0, 2, 1, 1024), DISK_NO_SECTOR);
    assert_int_equal(serve(0x56, 77, 0, 1, 1024), DISK_NO_ADDRESS_MARK);
    assert_int_equal(serve(0x55, 76, 1, 9, 1024), DISK_NO_SECTOR);
}

static void sector_addresses_come_round_as_the_disk_turns(void **state) {
    (void)state;
    for (unsigned i = 0; i < 17; i++) {
        assert_int_equal(serve(0x5A, 76, 1, 0, 0), DISK_DONE);
        assert_int_equal(call.cl, 76);
        assert_int_equal(call.dh, 1);
        assert_int_equal(call.dl, 1 + i % 8);
        assert_int_equal(call.ch, 3);
    }
    assert_int_equal(serve(0x5A, 77, 0, 0, 0), DISK_NO_ADDRESS_MARK);
}

static void what_is_no_such_drive_or_function_is_told(void **state) {
    static const struct {
        uint8_t ah, al;
        enum pc98_disk_status status;
    } known[] = {{0x56, 0x91, DISK_NOT_READY},
                 {0x56, 0x93, DISK_NOT_READY},
                 {0x56, 0x10, DISK_NO_ADDRESS_MARK},
                 {0x56, 0x70, DISK_EQUIPMENT},
                 {0x56, 0x80, DISK_EQUIPMENT},
                 {0x56, 0xF0, DISK_EQUIPMENT},
                 {0x03, 0x92, DISK_DONE},
                 {0x52, 0x90, DISK_NOT_EMULATED},
                 {0x59, 0x90, DISK_NOT_EMULATED},
                 {0x5C, 0x90, DISK_NOT_EMULATED},
                 {0x5D, 0x90, DISK_NOT_EMULATED},
                 {0x0E, 0x90, DISK_NOT_EMULATED},
                 {0x08, 0x90, DISK_NOT_EMULATED},
                 {0x84, 0x10, (enum pc98_disk_status)0x08}};
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        (void)serve(0x07, 0, 0, 0, 0);
        call.ah = known[i].ah;
        call.al = known[i].al;
        call.ch = 3;
        call.dl = 1;
        call.bx = 1024;
        assert_int_equal(pc98_disk_serve(&disk, &call), known[i].status);
    }
}

#define ON_A_DISK(test) cmocka_unit_test_setup(test, make_disk)

int main(void) {
    const struct CMUnitTest tests[] = {
        ON_A_DISK(each_sector_is_where_its_address_says),
        ON_A_DISK(a_long_read_goes_on_in_the_track_and_by_mt_on_the_other_side),
        ON_A_DISK(an_error_leaves_what_was_read_before),
        ON_A_DISK(a_cut_sector_is_read_in_part_and_written_with_zeros),
        ON_A_DISK(a_write_mends_a_sector_unless_the_disk_is_protected),
        ON_A_DISK(a_transfer_may_end_at_a_border_and_not_cross_it),
        ON_A_DISK(what_is_no_sector_is_not_found),
        ON_A_DISK(sector_addresses_come_round_as_the_disk_turns),
        ON_A_DISK(what_is_no_such_drive_or_function_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
