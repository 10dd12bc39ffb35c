/* SPDX-License-Identifier: MIT */
/* The SuperFrame board as a plain, copyable struct: write a port, read a port, look inside.
 *
 * Ports, addresses and screen are in board_ports.h.
 *
 * Grades, best first: P the paper's Table 2; D drivers of 1991-93; S a jumper sheet of a later
 * board. I is inferred from P and D; A is assumed, because something has to happen. ! means:
 * reported as a violation.
 *
 * TRUTH TABLE (docs/board.md has every cell; tests/unit/emulator/board_table_test.c drives the
 * emulator by it).
 *
 *     access                    effect                                       1987    later
 *     byte, even, write         the low byte of the register.                P D I   P D I
 *       X, Y                    bits 7-0 replaced, the upper bits kept.      I       I
 *     word, even, write         the register; its don't-care bits ignored.   P D     P D
 *       red                     1987: as a byte; later: the fill, below.     A !     I
 *       green, blue             as a byte.                                   A !     A !
 *     byte, odd, write          X, Y: the upper bits; the others: nothing.   A !     A !
 *     word, odd                 two bytes, the lower port first.             A !     A !
 *     byte, even, read          red, green, blue: of the pixel.              P       P
 *       control 2               what was last written to that index.         I       I
 *                               later, index 1Fh: status, bit 1 = blank.     -       D
 *       control 1               0000h whatever was written.                  A !     word D, byte I
 *       X, Y, mode              FFh.                                         A !     A !
 *     word, even, read          X, Y, mode: FFFFh (control 1: above).        A !     A !
 *       control 2               as the byte, high byte FFh.                  I       I
 *       red, green, blue        as the byte, high byte FFh.                  A !     A !
 *     byte, odd, read           FFh (control 1: 00h).                        A !     A !
 *     outside the 16 ports      write: nothing (D); read: FFh (A !).
 *
 * Other behaviours:
 *
 *     X >= 640 or Y >= 400      a pixel write is ignored, a read gives FFh.  A !     A !
 *                               (Or X - 640 on the same line, by desc.)
 *     Y 400..407, X 0..383      hidden blocks: pixels that are not shown.    A !     D
 *     word write of red         fills 4 pixels in all 3 primaries.           -       I
 *       X not 4n, value not 0   X rounded down, the low byte taken.          -       A !
 *     mode 00, 01, 03           PC screen, both, SuperFrame.                 D       D
 *     mode 40                   later: X + 1 after a byte write of blue.     A !     A !
 *     mode, any other bit       stored, no effect.                           A !     A !
 *                               (08 is GRAYMODE, 80 STEALWR.)
 *     0Ch, 0Dh                  later: display start address, complemented.  A !     I
 *     13h, 14h                  the second screen's: stored, no effect.      A !     A !
 *     index that is neither     stored, no effect.                           A !     A !
 *       initialised nor above
 *     power-on                  registers 0, mode 00, memory as in the desc. A       A
 *     status bit 1              set for the last 40/440 of every             -       A
 *                               44326 accesses, or as board_set_blanking()
 *                               was told.
 *
 * NOT IMPLEMENTED: GRAYMODE, STEALWR, the second screen, the controller's cursor, light pen and
 * interrupts, wait states, DMA. Nor is time: an access takes no time, and the blanking follows the
 * number of accesses, or whoever keeps the time. Nobody knows what a real board does there. */
#ifndef SUPERFRAME_EMULATOR_BOARD_H
#define SUPERFRAME_EMULATOR_BOARD_H

#include "board_ports.h"
#include "bus.h"

#include <stdbool.h>
#include <stdint.h>

enum {
    BOARD_MEMORY_HEIGHT = 416, /* lines in memory: the last 16 are the hidden blocks */
    BOARD_HIDDEN_WIDTH = 384,  /* pixels on a line of the hidden blocks */
    BOARD_HIDDEN_HEIGHT = 408, /* the first line that can't be reached */
    BOARD_BLOCK_WIDTH = 8,     /* a block of the frame memory, in pixels */
    BOARD_BLOCK_HEIGHT = 16,
    BOARD_BLOCKS = 2048,
    BOARD_BLOCKS_ON_A_ROW = 80,
    BOARD_MEMORY_BYTES = BOARD_WIDTH * BOARD_MEMORY_HEIGHT * 3
};

/* How well a behaviour is known, best first; `>=` therefore means "no better known than". */
enum board_grade { GRADE_PAPER, GRADE_DRIVER, GRADE_SHEET, GRADE_INFERRED, GRADE_ASSUMED };

/* Which board. 1987: the paper's, with the initialisation and modes 00, 01, 03. Later: all that
 * the drivers of 1991-93 do. */
enum board_profile { BOARD_1987, BOARD_LATER, BOARD_PROFILES };

/* What a pixel access at X >= 640 does; reported either way (grade A). */
enum board_outside { BOARD_OUTSIDE_IGNORED, BOARD_OUTSIDE_WRAPS };

/* Says where the status takes the vertical blanking from. Counted: from the number of accesses. The
 * others: from outside, the CRT is in the blanking or not. */
enum board_blanking {
    BOARD_BLANKING_COUNTED,
    BOARD_BLANKING_OFF,
    BOARD_BLANKING_ON,
    BOARD_BLANKINGS
};

/* What the board did for an access. Every behaviour has a grade and a verdict in each profile:
 * board_behaviour_grade(), board_behaviour_is_violation(). */
enum board_behaviour {
    BOARD_INDEX_WRITE,        /* control 1 taken as the index */
    BOARD_DATA_WRITE,         /* control 2 taken as the indexed register's data */
    BOARD_DATA_READ,          /* control 2 gave what was last written to the index */
    BOARD_STATUS_READ,        /* control 2 gave the status of index 1Fh */
    BOARD_POSITION_WRITE,     /* X or Y written as a word */
    BOARD_POSITION_LOW_WRITE, /* X or Y written as a byte: bits 7-0 */
    BOARD_PRIMARY_WRITE,      /* a byte of red, green or blue written */
    BOARD_PRIMARY_READ,       /* a byte of red, green or blue read */
    BOARD_MODE_WRITE,         /* mode set to 00, 01 or 03 */
    BOARD_CONTROL1_READ,      /* control 1 read as a word */
    BOARD_CONTROL1_BYTE_READ, /* control 1 read as a byte */
    BOARD_RED_WORD_WRITE,     /* red written as a word: the fill of the later boards */
    BOARD_HIDDEN_ACCESS,      /* a pixel of the hidden blocks */
    BOARD_START_ADDRESS,      /* a display start other than 0 */
    BOARD_WORD_SPLIT,         /* a word at an odd port, taken as two bytes */
    BOARD_FOREIGN_WRITE,      /* a write outside the board's ports */
    /* From here on: violations in both profiles, grade A. */
    BOARD_FILL_UNSEEN,         /* a fill with X not a multiple of 4 or a value other than 0 */
    BOARD_POSITION_HIGH_WRITE, /* a byte at the odd port of X or Y */
    BOARD_ODD_WRITE,           /* a byte at another odd port */
    BOARD_ODD_READ,            /* a byte read from an odd port */
    BOARD_PRIMARY_WORD_WRITE,  /* green or blue written as a word */
    BOARD_PRIMARY_WORD_READ,   /* red, green or blue read as a word: the high byte is prohibited */
    BOARD_WRITE_ONLY_READ,     /* X, Y or mode read */
    BOARD_FOREIGN_READ,        /* a read outside the board's ports */
    BOARD_OUTSIDE_WRITE,       /* a pixel written outside the frame memory */
    BOARD_OUTSIDE_READ,        /* a pixel read outside the frame memory */
    BOARD_UNKNOWN_INDEX,       /* data for an index that nobody knows */
    BOARD_UNWRITTEN_READ,      /* data read from an index that was never written */
    BOARD_MODE_UNKNOWN,        /* a mode with bits that have no known meaning */
    BOARD_AUTO_INCREMENT,      /* X stepped by mode bit 40h */
    BOARD_BEHAVIOURS
};

/* How the board is made. Start from board_default_desc(). */
struct board_desc {
    enum board_profile profile;
    uint16_t base; /* 00D0h, 02D0h, ... 0CD0h: board_base_is_offered() (grade S) */
    enum board_outside outside;
    bool noise;          /* false: the frame memory starts black; true: seeded noise */
    uint64_t noise_seed; /* any value, 0 too */
};

/* One entry of the log. */
struct board_violation {
    uint64_t access; /* its number: 1 is the first access after board_init() */
    enum board_behaviour behaviour;
    uint16_t port;
    uint16_t value; /* written, or given to the reader */
    uint8_t width;  /* bytes: 1 or 2 */
    bool is_read;
};

/* The pixels of the frame memory that X and Y have named since board_take_changes(), as a
 * rectangle. Right and bottom are the first column and line outside. */
struct board_changes {
    uint16_t left, top, right, bottom; /* none: 640, 416, 0, 0 */
    bool is_written;                   /* a pixel of them was written */
    bool is_all;                       /* whatever else decides what is shown has changed too */
};

/* How often a behaviour was relied on. */
struct board_note {
    uint64_t count;
    uint64_t first; /* the first access that did; 0: none */
};

enum { BOARD_LOG_SIZE = 64 };

/* The board. Copy it as you like; change it by ports. Fields are for reading. */
struct board {
    struct board_desc desc;
    uint16_t x, y;    /* as written: 0..1023, 0..511 */
    int32_t place;    /* byte offset of the pixel in memory, -1: outside */
    uint8_t index;    /* control 1 */
    uint8_t mode;     /* as written */
    bool is_stepping; /* mode bit 40h holds, and the profile knows it */
    bool is_wrapped;  /* place was found by wrapping X */
    enum board_blanking blanking;
    uint8_t controller[256];         /* by index */
    uint8_t controller_written[256]; /* 1: has been written since reset */
    uint64_t accesses;               /* all of them, foreign ports included */
    uint64_t writes[BOARD_PORTS][2]; /* by offset from the base, and width - 1 */
    uint64_t reads[BOARD_PORTS][2];
    struct board_note notes[BOARD_BEHAVIOURS];
    unsigned log_count; /* entries of the log that are used; the first BOARD_LOG_SIZE are kept */
    struct board_violation log[BOARD_LOG_SIZE];
    struct board_changes changes;
    /* R, G, B; BOARD_WIDTH pixels a line, BOARD_MEMORY_HEIGHT lines. write_png() can dump the first
     * 400 lines, or all 416 with the hidden blocks. Of the hidden blocks the board has the left 384
     * pixels. The last member: board_restore() checks whatever stands before it. */
    uint8_t memory[BOARD_MEMORY_BYTES];
};

/* Returns the factory's board of a profile: base 00D0h, X outside ignored, memory black. */
struct board_desc board_default_desc(enum board_profile profile);

/* Powers the board on. Returns false, and leaves the board untouched, if the desc has an unknown
 * profile or a base that the jumper doesn't offer. */
bool board_init(struct board *board, const struct board_desc *desc);

/* Resets the board as the machine's reset does: registers as at power-on; memory, counters and log
 * stay (grade A). */
void board_reset(struct board *board);

/* Says where the status takes the blanking from. Whoever keeps the time calls it when the blanking
 * begins and ends, or before each read. The factory's board counts. */
void board_set_blanking(struct board *board, enum board_blanking blanking);

/* Does one OUT to any port. width is 1, 2 or 4 bytes; of the value the low `width` bytes count.
 * Four bytes are two words on the PC-98's bus. The low one goes to `port`, then the high one to the
 * port two above. Another width is refused: it is no access, and nothing changes. */
void board_write(struct board *board, uint16_t port, uint32_t value, unsigned width);

/* Does one IN from any port, of four bytes as board_write() does. Returns 0..FFh for width 1,
 * 0..FFFFh for width 2, and FFFFFFFFh for a refused width. */
uint32_t board_read(struct board *board, uint16_t port, unsigned width);

/* Returns how many violations there were. One access can hold two (a word at an odd port). */
uint64_t board_violations(const struct board *board);

/* Returns how many times the program relied on a behaviour no better known than `grade`. A
 * behaviour counts whether it is a violation or not. GRADE_ASSUMED counts the assumed behaviours
 * only, GRADE_PAPER all. */
uint64_t board_reliances(const struct board *board, enum board_grade grade);

/* Returns the grade of a behaviour in a profile. */
enum board_grade board_behaviour_grade(enum board_behaviour behaviour, enum board_profile profile);

/* Tells whether a profile counts a behaviour as a violation. */
bool board_behaviour_is_violation(enum board_behaviour behaviour, enum board_profile profile);

/* Returns one English phrase for a behaviour, for messages. */
const char *board_behaviour_text(enum board_behaviour behaviour);

/* Returns the letter of a grade: "P", "D", "S", "I" or "A". */
const char *board_grade_letter(enum board_grade grade);

/* Reads a grade's letter or word ("A", "assumed", either case). Returns false if the text is
 * neither. */
bool board_grade_from_text(const char *text, enum board_grade *grade);

/* Returns the name of a profile: "1987" or "later". */
const char *board_profile_text(enum board_profile profile);

/* Reads a profile's name. Returns false if the text is none. */
bool board_profile_from_text(const char *text, enum board_profile *profile);

/* ---- On a bus ------------------------------------------------------------------------------- */

/* The board as a bus. The board must outlive the bus; several buses may share one board. */
struct board_bus {
    struct bus bus; /* the first member: bus_bind(&board_bus.bus) */
    struct board *board;
};

/* Plugs the board into a bus. Cannot fail. */
void board_bus_init(struct board_bus *board_bus, struct board *board);

#endif
