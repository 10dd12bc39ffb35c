/* SPDX-License-Identifier: MIT */
/* A 2HD floppy in its drive, and what the disk BIOS (INT 1Bh) answers of it. */
#ifndef SUPERFRAME_PC98_DISK_H
#define SUPERFRAME_PC98_DISK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    PC98_CYLINDERS = 77,
    PC98_HEADS = 2,
    PC98_SECTORS = 8, /* on a track, counted from 1 */
    PC98_SECTOR_BYTES = 1024,
    PC98_SECTOR_LENGTH = 3, /* as the disk records a sector's length: 128 << 3 bytes */
    PC98_DISK_SECTORS = PC98_CYLINDERS * PC98_HEADS * PC98_SECTORS,
    PC98_DISK_BYTES = PC98_DISK_SECTORS * PC98_SECTOR_BYTES,
    PC98_DRIVE = 0x90 /* DA/UA of the first drive with a 2HD disk */
};

/* What AH holds after a call of the disk BIOS. From 20h on the carry flag is set. The source is
 * UNDOCUMENTED (io_disk), which gives the bits of the controller that each status stands for. */
enum pc98_disk_status {
    DISK_DONE = 0x00,
    DISK_TWO_SIDED = 0x01,       /* a bit of sense */
    DISK_DUAL_DRIVE = 0x08,      /* a bit of sense: 1 MB and 640 KB; for AH = 84h */
    DISK_PROTECTED = 0x10,       /* a bit of sense */
    DISK_ERRORS = 0x20,          /* from here on the carry flag is set */
    DISK_BORDER = 0x20,          /* the transfer would cross a border of 64 KiB */
    DISK_END_OF_CYLINDER = 0x30, /* past the last sector of the track, or of both with MT */
    DISK_EQUIPMENT = 0x40,       /* no such drive on this interface */
    DISK_NOT_READY = 0x60,       /* a drive without a disk */
    DISK_NOT_WRITABLE = 0x70,    /* the disk is write-protected */
    DISK_DATA_ERROR = 0xB0,      /* the checksum of the data is wrong */
    DISK_NO_SECTOR = 0xC0,       /* no sector of that number, cylinder, head and length */
    DISK_NO_ADDRESS_MARK = 0xE0, /* another density, or a track that is not formatted */
    DISK_NOT_EMULATED = 0x100    /* no status: a function that is left out here */
};

/* The disk and its drive. Begins as all zero but for the image; about 1.3 MB. */
struct pc98_disk {
    uint8_t bytes[PC98_DISK_BYTES];    /* sector by sector, side by side, cylinder by cylinder */
    uint8_t status[PC98_DISK_SECTORS]; /* what a read of the sector gives: DISK_DONE, or an error */
    bool is_protected;
    uint8_t cylinder;   /* where the heads are */
    uint8_t id_sectors; /* sector addresses that were read so far, modulo 8: the disk turns */
};

/* The registers of a call, and the bytes that a write takes and a read gives. */
struct pc98_disk_call {
    uint8_t ah, al, ch, cl, dh, dl;
    uint16_t bx;       /* bytes to transfer */
    uint32_t address;  /* 16 * ES + BP, where they are in the machine */
    uint32_t received; /* bytes that a read has given, also before an error */
    uint8_t buffer[0x10000];
};

/* Does what INT 1Bh does, on the disk, in the buffer and, for read ID, in ch, cl, dh and dl.
 * Returns what AH is to hold, or DISK_NOT_EMULATED. */
enum pc98_disk_status pc98_disk_serve(struct pc98_disk *disk, struct pc98_disk_call *call);

#endif
