/* SPDX-License-Identifier: MIT */
/* What instructions of a 387 do on a machine that has none. */
#include "boot/absent_387.h"

#include <string.h>

#include "boot/instruction.h"

enum {
    FNCLEX = 0xDBE2,
    FNINIT = 0xDBE3,
    FNSTSW_AX = 0xDFE0,
    STORE_CONTROL = 0xD9, /* with digit 7: FNSTCW */
    STORE_STATUS = 0xDD,  /* with digit 7: FNSTSW */
    STORE_DIGIT = 7,
    ADDRESS_SIZE = 0x67,
    NO_REGISTER = -1
};

/* Returns the offset that ModRM and displacement name with 16 bits. */
static uint32_t offset_of(const uint8_t *modrm, const uint32_t *registers) {
    static const int pairs[8][2] = {{REGISTER_EBX, REGISTER_ESI}, {REGISTER_EBX, REGISTER_EDI},
                                    {REGISTER_EBP, REGISTER_ESI}, {REGISTER_EBP, REGISTER_EDI},
                                    {REGISTER_ESI, NO_REGISTER},  {REGISTER_EDI, NO_REGISTER},
                                    {REGISTER_EBP, NO_REGISTER},  {REGISTER_EBX, NO_REGISTER}};
    unsigned mode = *modrm >> 6, base = *modrm & 7;
    uint32_t word = modrm[1] | (uint32_t)modrm[2] << 8;
    if (mode == 0 && base == 6) {
        return word;
    }
    uint32_t offset = mode == 2 ? word : mode == 1 ? (uint32_t)(int8_t)modrm[1] : 0;
    for (unsigned i = 0; i < 2 && pairs[base][i] != NO_REGISTER; i++) {
        offset += registers[pairs[base][i]];
    }
    return offset & 0xFFFF;
}

/* Returns the segment register that a prefix chooses; without one, that of the address. */
static enum processor_register segment_of(uint8_t prefix, uint8_t modrm) {
    unsigned mode = modrm >> 6, base = modrm & 7;
    switch (prefix) {
    case 0x26:
        return REGISTER_ES;
    case 0x2E:
        return REGISTER_CS;
    case 0x36:
        return REGISTER_SS;
    case 0x3E:
        return REGISTER_DS;
    case 0x64:
        return REGISTER_FS;
    case 0x65:
        return REGISTER_GS;
    default: /* no prefix */
        return base == 2 || base == 3 || (base == 6 && mode != 0) ? REGISTER_SS : REGISTER_DS;
    }
}

struct absent_387_answer absent_387_answer(const uint8_t *bytes, size_t count,
                                           const uint32_t registers[PROCESSOR_REGISTERS]) {
    struct absent_387_answer answer = {.is_known = false};
    uint8_t code[INSTRUCTION_BYTES_MOST + 4] = {
        0}; /* and zeros behind it, for what ModRM does not have */
    memcpy(code, bytes, count < INSTRUCTION_BYTES_MOST ? count : INSTRUCTION_BYTES_MOST);
    struct instruction instruction = instruction_decode(code, INSTRUCTION_BYTES_MOST, false);
    if (instruction.kind != INSTRUCTION_387) {
        return answer;
    }
    const uint8_t *opcode = code + instruction.opcode;
    unsigned both = (unsigned)opcode[0] << 8 | opcode[1];
    bool is_store = (opcode[0] == STORE_CONTROL || opcode[0] == STORE_STATUS) &&
                    (opcode[1] >> 3 & 7) == STORE_DIGIT && opcode[1] >> 6 != 3;
    answer.length = (uint32_t)instruction.length;
    answer.is_ax = both == FNSTSW_AX;
    answer.is_stored = is_store;
    answer.is_known = both == FNCLEX || both == FNINIT || answer.is_ax || is_store;
    for (size_t i = 0; i < instruction.opcode; i++) {
        answer.is_known = answer.is_known && code[i] != ADDRESS_SIZE;
    }
    if (answer.is_known && is_store) {
        answer.address = 16 * (registers[segment_of(instruction.segment, opcode[1])] & 0xFFFF) +
                         offset_of(opcode + 1, registers);
    }
    return answer;
}
