/* SPDX-License-Identifier: MIT */
/* The lengths of the 386's instructions, and which of them a 386 without a 387 lacks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "boot/instruction.h"

/* Lengths are the manual's, counted by hand: opcode, ModRM, SIB, displacement, immediate. */
static const struct {
    const char *what;
    uint8_t bytes[16];
    size_t length_16, length_32; /* in a segment of 16 and of 32 bits */
    enum instruction_kind kind;
} known[] = {
    {"nop", {0x90}, 1, 1, INSTRUCTION_386},
    {"add al, bl", {0x00, 0xD8}, 2, 2, INSTRUCTION_386},
    {"add [6 or ebp-less], al", {0x00, 0x06, 1, 2}, 4, 2, INSTRUCTION_386},
    {"add [di or 5], al", {0x00, 0x05, 1, 2, 3, 4}, 2, 6, INSTRUCTION_386},
    {"add [si or sib], al", {0x00, 0x04, 0x24}, 2, 3, INSTRUCTION_386},
    {"add [sib without base]", {0x00, 0x04, 0x25, 1, 2, 3, 4}, 2, 7, INSTRUCTION_386},
    {"add [+8], al", {0x00, 0x47, 1}, 3, 3, INSTRUCTION_386},
    {"add [sib+8], al", {0x00, 0x44, 0x24, 1}, 3, 4, INSTRUCTION_386},
    {"add [+16 or 32], al", {0x00, 0x87, 1, 2, 3, 4}, 4, 6, INSTRUCTION_386},
    {"add al, 1", {0x04, 1}, 2, 2, INSTRUCTION_386},
    {"add eax, 1", {0x05, 1, 2, 3, 4}, 3, 5, INSTRUCTION_386},
    {"66 add eax, 1", {0x66, 0x05, 1, 2, 3, 4}, 6, 4, INSTRUCTION_386},
    {"67 add [di or 5], al", {0x67, 0x00, 0x05, 1, 2, 3, 4}, 7, 3, INSTRUCTION_386},
    {"66 66 add eax, 1", {0x66, 0x66, 0x05, 1, 2, 3, 4}, 7, 5, INSTRUCTION_386},
    {"es: lock add [bx], al", {0x26, 0xF0, 0x00, 0x07}, 4, 4, INSTRUCTION_386},
    {"push word", {0x68, 1, 2, 3, 4}, 3, 5, INSTRUCTION_386},
    {"imul by a word", {0x69, 0xC0, 1, 2, 3, 4}, 4, 6, INSTRUCTION_386},
    {"push byte", {0x6A, 1}, 2, 2, INSTRUCTION_386},
    {"imul by a byte", {0x6B, 0xC0, 1}, 3, 3, INSTRUCTION_386},
    {"jz", {0x74, 1}, 2, 2, INSTRUCTION_386},
    {"add ax, word", {0x81, 0xC0, 1, 2, 3, 4}, 4, 6, INSTRUCTION_386},
    {"add ax, byte", {0x83, 0xC0, 1}, 3, 3, INSTRUCTION_386},
    {"call far", {0x9A, 1, 2, 3, 4, 5, 6}, 5, 7, INSTRUCTION_386},
    {"mov al, [address]", {0xA0, 1, 2, 3, 4}, 3, 5, INSTRUCTION_386},
    {"mov al, 1", {0xB0, 1}, 2, 2, INSTRUCTION_386},
    {"mov ax, 1", {0xB8, 1, 2, 3, 4}, 3, 5, INSTRUCTION_386},
    {"shl ax, 1", {0xC1, 0xE0, 1}, 3, 3, INSTRUCTION_386},
    {"ret 2", {0xC2, 2, 0}, 3, 3, INSTRUCTION_386},
    {"mov ax, 1 by C7", {0xC7, 0xC0, 1, 2, 3, 4}, 4, 6, INSTRUCTION_386},
    {"enter", {0xC8, 1, 2, 3}, 4, 4, INSTRUCTION_386},
    {"int", {0xCD, 0x1B}, 2, 2, INSTRUCTION_386},
    {"jmp far", {0xEA, 1, 2, 3, 4, 5, 6}, 5, 7, INSTRUCTION_386},
    {"test al, 1", {0xF6, 0xC0, 1}, 3, 3, INSTRUCTION_386},
    {"not al", {0xF6, 0xD0}, 2, 2, INSTRUCTION_386},
    {"test ax, 1", {0xF7, 0xC0, 1, 2, 3, 4}, 4, 6, INSTRUCTION_386},
    {"neg ax", {0xF7, 0xD8}, 2, 2, INSTRUCTION_386},
    {"jz near", {0x0F, 0x84, 1, 2, 3, 4}, 4, 6, INSTRUCTION_386},
    {"setz al", {0x0F, 0x94, 0xC0}, 3, 3, INSTRUCTION_386},
    {"shld by 1", {0x0F, 0xA4, 0xC0, 1}, 4, 4, INSTRUCTION_386},
    {"bt ax, 1", {0x0F, 0xBA, 0xE0, 1}, 4, 4, INSTRUCTION_386},
    {"movzx", {0x0F, 0xB6, 0xC0}, 3, 3, INSTRUCTION_386},
    {"lgdt", {0x0F, 0x01, 0x17}, 3, 3, INSTRUCTION_386},
    {"mov eax, cr0", {0x0F, 0x20, 0xC0}, 3, 3, INSTRUCTION_386},
    {"mov cr0, eax", {0x0F, 0x22, 0xC0}, 3, 3, INSTRUCTION_CONTROL},
    {"mov cr0 as memory", {0x0F, 0x22, 0x06}, 3, 3, INSTRUCTION_CONTROL},
    {"lmsw ax", {0x0F, 0x01, 0xF0}, 3, 3, INSTRUCTION_CONTROL},
    {"smsw ax", {0x0F, 0x01, 0xE0}, 3, 3, INSTRUCTION_386},
    {"fninit", {0xDB, 0xE3}, 2, 2, INSTRUCTION_387},
    {"fnstsw [word]", {0xDD, 0x3E, 1, 2}, 4, 2, INSTRUCTION_387},
    {"cs: fld1", {0x2E, 0xD9, 0xE8}, 3, 3, INSTRUCTION_387},
    {"bswap", {0x0F, 0xC8}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"cpuid", {0x0F, 0xA2}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"cmpxchg", {0x0F, 0xB1, 0xC0}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"xadd", {0x0F, 0xC1, 0xC0}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"invd", {0x0F, 0x08}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"wbinvd", {0x0F, 0x09}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"rdtsc", {0x0F, 0x31}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"cmovz", {0x0F, 0x44, 0xC0}, 2, 2, INSTRUCTION_NOT_ON_A_386},
    {"invlpg", {0x0F, 0x01, 0x3F}, 3, 3, INSTRUCTION_NOT_ON_A_386},
};

static void lengths_and_kinds_are_the_manuals(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        for (unsigned is_32 = 0; is_32 < 2; is_32++) {
            size_t length = is_32 != 0 ? known[i].length_32 : known[i].length_16;
            struct instruction found =
                instruction_decode(known[i].bytes, sizeof known[i].bytes, is_32 != 0);
            if (found.length != length || found.kind != known[i].kind) {
                fail_msg("%s, %s: %zu bytes, kind %d", known[i].what, is_32 != 0 ? "32" : "16",
                         found.length, (int)found.kind);
            }
            /* One byte less: too little to tell. */
            found = instruction_decode(known[i].bytes, length - 1, is_32 != 0);
            assert_int_equal(found.length, 0);
            assert_int_equal(found.kind, INSTRUCTION_386);
        }
    }
}

static void prefixes_are_told_from_the_opcode(void **state) {
    (void)state;
    const uint8_t store[] = {0x66, 0x3E, 0xDD, 0x3E, 0, 0};
    struct instruction found = instruction_decode(store, sizeof store, false);
    assert_int_equal(found.opcode, 2);
    assert_int_equal(found.segment, 0x3E);
    found = instruction_decode(store + 2, sizeof store - 2, false);
    assert_int_equal(found.opcode, 0);
    assert_int_equal(found.segment, 0);
    const uint8_t prefixes[15] = {0x66, 0x66, 0x66, 0x66, 0x66, 0x66, 0x66, 0x66};
    assert_int_equal(instruction_decode(prefixes, 8, false).length, 0);
    assert_int_equal(instruction_decode(prefixes, 0, false).length, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_and_kinds_are_the_manuals),
        cmocka_unit_test(prefixes_are_told_from_the_opcode),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
