/* SPDX-License-Identifier: MIT */
/* The instructions of a 386, as far as their lengths. */
#include "boot/instruction.h"

/* A letter for each opcode says what follows the opcode.
 *
 * - is nothing, b a byte, w two bytes, e three. z is a word or doubleword, by the operand's size.
 * p is that and a selector. o is an address, by the address's size.
 *
 * m is ModRM with its displacement, B the same and a byte, Z the same and a word or doubleword. g
 * and G are B and Z for TEST alone (/0, /1), and else m. r is ModRM that names registers only.
 *
 * c is r where a control register is written. s is m where /6 is LMSW, and /7 of the 486. x is m
 * for the coprocessor. P is a prefix, t a first byte of two, and ! no opcode of a 386. */
static const char one_byte[] = "mmmmbz--mmmmbz-t"
                               "mmmmbz--mmmmbz--"
                               "mmmmbzP-mmmmbzP-"
                               "mmmmbzP-mmmmbzP-"
                               "----------------"
                               "----------------"
                               "--mmPPPPzZbB----"
                               "bbbbbbbbbbbbbbbb"
                               "BZBBmmmmmmmmmmmm"
                               "----------p-----"
                               "oooo----bz------"
                               "bbbbbbbbzzzzzzzz"
                               "BBw-mmBZe-w--b--"
                               "mmmmbb--xxxxxxxx"
                               "bbbbbbbbzzpb----"
                               "P!PP--gG------mm";

static const char two_bytes[] = "msmm!!-!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "rrcrr!r!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "zzzzzzzzzzzzzzzz"
                                "mmmmmmmmmmmmmmmm"
                                "--!mBm!!--!mBm!m"
                                "!!mmmmmm!!Bmmmmm"
                                "!!!!!!!!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!"
                                "!!!!!!!!!!!!!!!!";

enum { LMSW_DIGIT = 6, INVLPG_DIGIT = 7, PREFIX_OPERAND = 0x66, PREFIX_ADDRESS = 0x67 };

/* An instruction that is being decoded. */
struct reading {
    const uint8_t *bytes;
    size_t count, at;
    bool is_operand_32, is_address_32;
};

static unsigned peek(const struct reading *reading, size_t ahead) {
    return reading->at + ahead < reading->count ? reading->bytes[reading->at + ahead] : 0;
}

/* Returns the bytes of ModRM and what belongs to it: SIB and displacement. */
static size_t modrm_bytes(const struct reading *reading) {
    unsigned modrm = peek(reading, 0);
    unsigned mode = modrm >> 6, base = modrm & 7;
    size_t displacement = mode == 1 ? 1 : 0;
    if (mode == 3) {
        return 1;
    }
    if (!reading->is_address_32) {
        return 1 + (mode == 2 || (mode == 0 && base == 6) ? 2 : displacement);
    }
    size_t bytes = base == 4 ? 2 : 1;
    unsigned sib_base = base == 4 ? peek(reading, 1) & 7 : base;
    return bytes + (mode == 2 || (mode == 0 && sib_base == 5) ? 4 : displacement);
}

/* Returns how many bytes follow an opcode of this letter. */
static size_t rest_bytes(const struct reading *reading, char letter) {
    size_t word = reading->is_operand_32 ? 4 : 2;
    bool is_test = (peek(reading, 0) >> 3 & 7) < 2;
    switch (letter) {
    case 'b':
    case 'r':
    case 'c':
        return 1;
    case 'w':
        return 2;
    case 'e':
        return 3;
    case 'z':
        return word;
    case 'p':
        return word + 2;
    case 'o':
        return reading->is_address_32 ? 4 : 2;
    case 'm':
    case 's':
    case 'x':
        return modrm_bytes(reading);
    case 'B':
        return modrm_bytes(reading) + 1;
    case 'Z':
        return modrm_bytes(reading) + word;
    case 'g':
        return modrm_bytes(reading) + (is_test ? 1 : 0);
    case 'G':
        return modrm_bytes(reading) + (is_test ? word : 0);
    default: /* nothing follows, or nobody knows what */
        return 0;
    }
}

static enum instruction_kind kind_of(const struct reading *reading, char letter) {
    unsigned digit = peek(reading, 0) >> 3 & 7;
    if (letter == '!' || (letter == 's' && digit == INVLPG_DIGIT)) {
        return INSTRUCTION_NOT_ON_A_386;
    }
    if (letter == 'x') {
        return INSTRUCTION_387;
    }
    return letter == 'c' || (letter == 's' && digit == LMSW_DIGIT) ? INSTRUCTION_CONTROL
                                                                   : INSTRUCTION_386;
}

/* Reads the prefixes. An operand's or an address's size is changed once, however often it is
 * asked for. */
static void read_prefixes(struct reading *reading, struct instruction *instruction, bool is_32) {
    while (reading->at < reading->count && one_byte[peek(reading, 0)] == 'P') {
        unsigned prefix = peek(reading, 0);
        if (prefix == PREFIX_OPERAND) {
            reading->is_operand_32 = !is_32;
        } else if (prefix == PREFIX_ADDRESS) {
            reading->is_address_32 = !is_32;
        } else if (prefix < 0x80) {
            instruction->segment = (uint8_t)prefix;
        }
        reading->at++;
    }
}

struct instruction instruction_decode(const uint8_t *bytes, size_t count, bool is_32) {
    struct reading reading = {bytes, count, 0, is_32, is_32};
    struct instruction instruction = {INSTRUCTION_386, 0, 0, 0};
    read_prefixes(&reading, &instruction, is_32);
    if (reading.at >= count) {
        return instruction;
    }
    instruction.opcode = reading.at;
    char letter = one_byte[peek(&reading, 0)];
    reading.at++;
    if (letter == 't') {
        if (reading.at >= count) {
            return instruction;
        }
        letter = two_bytes[peek(&reading, 0)];
        reading.at++;
    }
    size_t length = reading.at + rest_bytes(&reading, letter);
    if (length > count) {
        return instruction;
    }
    instruction.kind = kind_of(&reading, letter);
    instruction.length = length;
    return instruction;
}
