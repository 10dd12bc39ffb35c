/* SPDX-License-Identifier: MIT */
/* A 2HD floppy in its drive, and what the disk BIOS (INT 1Bh) answers of it. */
#include "boot/pc98_disk.h"

#include <string.h>

/* The low four bits of AH: what is done. */
enum {
    FUNCTION_SEEK = 0x0,
    FUNCTION_VERIFY = 0x1,
    FUNCTION_INITIALISE = 0x3,
    FUNCTION_SENSE = 0x4,
    FUNCTION_WRITE = 0x5,
    FUNCTION_READ = 0x6,
    FUNCTION_RECALIBRATE = 0x7,
    FUNCTION_READ_ID = 0xA,
    FUNCTIONS = 0x0F
};

/* The high four bits of AH: how. Bit 5 says "no retries", and there are no errors by chance. */
enum { BOTH_SIDES = 0x80, DENSITY_MFM = 0x40, SEEK_FIRST = 0x10 };

enum { UNIT_BITS = 0x03, INTERFACE_BITS = 0xF0, INTERFACE_2HD = 0x90, INTERFACE_DUAL = 0x10 };

static void seek(struct pc98_disk *disk, const struct pc98_disk_call *call) {
    if ((call->ah & SEEK_FIRST) != 0) {
        disk->cylinder = call->cl;
    }
}

/* Tells whether the heads stand over a track that they can read in the density that is asked
 * for. */
static bool track_is_readable(const struct pc98_disk *disk, const struct pc98_disk_call *call) {
    return disk->cylinder < PC98_CYLINDERS && (call->ah & DENSITY_MFM) != 0 &&
           (call->al & INTERFACE_BITS) == INTERFACE_2HD;
}

/* Tells whether the transfer would cross a border of 64 KiB, where the DMA controller's address
 * begins anew. */
static bool crosses_border(const struct pc98_disk_call *call) {
    return (call->address & 0xFFFF) + call->bx > 0x10000;
}

/* Transfers a sector or the part of one that is left. */
static void transfer(struct pc98_disk *disk, struct pc98_disk_call *call, size_t sector,
                     uint32_t done, uint32_t bytes) {
    uint8_t *on_disk = disk->bytes + sector * PC98_SECTOR_BYTES;
    if ((call->ah & FUNCTIONS) == FUNCTION_READ) {
        memcpy(call->buffer + done, on_disk, bytes);
        call->received = done + bytes;
    } else if ((call->ah & FUNCTIONS) == FUNCTION_WRITE) {
        memset(on_disk, 0, PC98_SECTOR_BYTES); /* the controller fills up a sector that is cut */
        memcpy(on_disk, call->buffer + done, bytes);
        disk->status[sector] = DISK_DONE;
    }
}

/* Reads, writes or verifies sector after sector. */
static enum pc98_disk_status go_over_sectors(struct pc98_disk *disk, struct pc98_disk_call *call) {
    unsigned head = call->dh, number = call->dl;
    bool is_write = (call->ah & FUNCTIONS) == FUNCTION_WRITE;
    if ((call->ah & FUNCTIONS) != FUNCTION_VERIFY && crosses_border(call)) {
        return DISK_BORDER;
    }
    seek(disk, call);
    if (is_write && disk->is_protected) {
        return DISK_NOT_WRITABLE;
    }
    if (!track_is_readable(disk, call)) {
        return DISK_NO_ADDRESS_MARK;
    }
    for (uint32_t done = 0; done < call->bx; done += PC98_SECTOR_BYTES, number++) {
        uint32_t left = call->bx - done;
        if (done > 0 && number == PC98_SECTORS + 1) {
            if ((call->ah & BOTH_SIDES) == 0 || head != 0) {
                return DISK_END_OF_CYLINDER;
            }
            head = 1;
            number = 1;
        }
        if (call->ch != PC98_SECTOR_LENGTH || call->cl != disk->cylinder || head >= PC98_HEADS ||
            number < 1 || number > PC98_SECTORS) {
            return DISK_NO_SECTOR;
        }
        size_t sector = (size_t)(disk->cylinder * PC98_HEADS + head) * PC98_SECTORS + number - 1;
        if (!is_write && disk->status[sector] != DISK_DONE) {
            return (enum pc98_disk_status)disk->status[sector];
        }
        transfer(disk, call, sector, done, left < PC98_SECTOR_BYTES ? left : PC98_SECTOR_BYTES);
    }
    return DISK_DONE;
}

/* Reads the address of the sector that comes next under the head. */
static enum pc98_disk_status read_id(struct pc98_disk *disk, struct pc98_disk_call *call) {
    seek(disk, call);
    if (!track_is_readable(disk, call)) {
        return DISK_NO_ADDRESS_MARK;
    }
    call->cl = disk->cylinder;
    call->dh = call->dh & 1;
    call->dl = (uint8_t)(disk->id_sectors + 1);
    call->ch = PC98_SECTOR_LENGTH;
    disk->id_sectors = (uint8_t)((disk->id_sectors + 1) % PC98_SECTORS);
    return DISK_DONE;
}

static enum pc98_disk_status sense(const struct pc98_disk *disk,
                                   const struct pc98_disk_call *call) {
    unsigned bits = disk->is_protected ? DISK_PROTECTED : 0;
    if ((call->al & INTERFACE_BITS) == INTERFACE_2HD) {
        bits |= DISK_TWO_SIDED;
    }
    if (call->ah == (BOTH_SIDES | FUNCTION_SENSE)) {
        bits |= DISK_DUAL_DRIVE;
    }
    return (enum pc98_disk_status)bits;
}

enum pc98_disk_status pc98_disk_serve(struct pc98_disk *disk, struct pc98_disk_call *call) {
    unsigned interface = call->al & INTERFACE_BITS;
    call->received = 0;
    if (interface != INTERFACE_2HD && interface != INTERFACE_DUAL) {
        return DISK_EQUIPMENT;
    }
    if ((call->ah & FUNCTIONS) == FUNCTION_INITIALISE) {
        return DISK_DONE;
    }
    if ((call->al & UNIT_BITS) != (PC98_DRIVE & UNIT_BITS)) {
        return DISK_NOT_READY;
    }
    switch (call->ah & FUNCTIONS) {
    case FUNCTION_SEEK:
        seek(disk, call);
        return DISK_DONE;
    case FUNCTION_RECALIBRATE:
        disk->cylinder = 0;
        return DISK_DONE;
    case FUNCTION_SENSE:
        return sense(disk, call);
    case FUNCTION_READ_ID:
        return read_id(disk, call);
    case FUNCTION_VERIFY:
    case FUNCTION_WRITE:
    case FUNCTION_READ:
        return go_over_sectors(disk, call);
    default:
        return DISK_NOT_EMULATED;
    }
}
