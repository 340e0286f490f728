// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/**
 * Instructions of the AVRe+ core with their opcodes as in the AVR Instruction Set Manual (DS40002198): d and r are
 * registers, K constants, k addresses, q displacements, A I/O addresses, b and s bits.
 */
enum Instruction {
    NOP("0000000000000000"), MOVW("00000001ddddrrrr"), MULS("00000010ddddrrrr"), MULSU("000000110ddd0rrr"),
    FMUL("000000110ddd1rrr"), FMULS("000000111ddd0rrr"), FMULSU("000000111ddd1rrr"),
    CPC("000001rdddddrrrr"), SBC("000010rdddddrrrr"), ADD("000011rdddddrrrr"), CPSE("000100rdddddrrrr"),
    CP("000101rdddddrrrr"), SUB("000110rdddddrrrr"), ADC("000111rdddddrrrr"), AND("001000rdddddrrrr"),
    EOR("001001rdddddrrrr"), OR("001010rdddddrrrr"), MOV("001011rdddddrrrr"),
    CPI("0011KKKKddddKKKK"), SBCI("0100KKKKddddKKKK"), SUBI("0101KKKKddddKKKK"), ORI("0110KKKKddddKKKK"),
    ANDI("0111KKKKddddKKKK"), LDI("1110KKKKddddKKKK"),
    LDD_Z("10q0qq0ddddd0qqq"), LDD_Y("10q0qq0ddddd1qqq"), STD_Z("10q0qq1ddddd0qqq"), STD_Y("10q0qq1ddddd1qqq"),
    LDS("1001000ddddd0000"), LD_Z_INC("1001000ddddd0001"), LD_DEC_Z("1001000ddddd0010"), LPM("1001000ddddd0100"),
    LPM_INC("1001000ddddd0101"), ELPM("1001000ddddd0110"), ELPM_INC("1001000ddddd0111"),
    LD_Y_INC("1001000ddddd1001"), LD_DEC_Y("1001000ddddd1010"), LD_X("1001000ddddd1100"),
    LD_X_INC("1001000ddddd1101"), LD_DEC_X("1001000ddddd1110"), POP("1001000ddddd1111"),
    STS("1001001ddddd0000"), ST_Z_INC("1001001ddddd0001"), ST_DEC_Z("1001001ddddd0010"),
    ST_Y_INC("1001001ddddd1001"), ST_DEC_Y("1001001ddddd1010"), ST_X("1001001ddddd1100"),
    ST_X_INC("1001001ddddd1101"), ST_DEC_X("1001001ddddd1110"), PUSH("1001001ddddd1111"),
    COM("1001010ddddd0000"), NEG("1001010ddddd0001"), SWAP("1001010ddddd0010"), INC("1001010ddddd0011"),
    ASR("1001010ddddd0101"), LSR("1001010ddddd0110"), ROR("1001010ddddd0111"), DEC("1001010ddddd1010"),
    BSET("100101000sss1000"), BCLR("100101001sss1000"), IJMP("1001010000001001"), EIJMP("1001010000011001"),
    RET("1001010100001000"), ICALL("1001010100001001"), RETI("1001010100011000"), EICALL("1001010100011001"),
    SLEEP("1001010110001000"), BREAK("1001010110011000"), WDR("1001010110101000"), LPM_R0("1001010111001000"),
    ELPM_R0("1001010111011000"), SPM("1001010111101000"), JMP("1001010kkkkk110k"), CALL("1001010kkkkk111k"),
    ADIW("10010110KKddKKKK"), SBIW("10010111KKddKKKK"), CBI("10011000AAAAAbbb"), SBIC("10011001AAAAAbbb"),
    SBI("10011010AAAAAbbb"), SBIS("10011011AAAAAbbb"), MUL("100111rdddddrrrr"), IN("10110AAdddddAAAA"),
    OUT("10111AAdddddAAAA"), RJMP("1100kkkkkkkkkkkk"), RCALL("1101kkkkkkkkkkkk"), BRBS("111100kkkkkkksss"),
    BRBC("111101kkkkkkksss"), BLD("1111100ddddd0bbb"), BST("1111101ddddd0bbb"), SBRC("1111110ddddd0bbb"),
    SBRS("1111111ddddd0bbb"),
    /** Any opcode that the manual does not assign. */
    RESERVED("");

    private static final int OPCODES = 0x10000;
    private static final Instruction[] DECODED = decodeAll();

    private final int mask;
    private final int pattern;

    Instruction(String bits) {
        mask = bits.isEmpty() ? 0 : Integer.parseInt(bits.replace('0', '1').replaceAll("[^1]", "0"), 2);
        pattern = bits.isEmpty() ? 0 : Integer.parseInt(bits.replaceAll("[^1]", "0"), 2);
    }

    private static Instruction[] decodeAll() {
        Instruction[] decoded = new Instruction[OPCODES];
        for (int opcode = 0; opcode < OPCODES; opcode++) {
            Instruction found = RESERVED;
            for (int i = 0; i < RESERVED.ordinal() && found == RESERVED; i++) {
                Instruction each = values()[i];
                found = (opcode & each.mask) == each.pattern ? each : RESERVED;
            }
            decoded[opcode] = found;
        }
        return decoded;
    }

    /** Decodes a program: one instruction per word, also for words that are operands. */
    static Instruction of(int opcode) {
        return DECODED[opcode];
    }

    /** Whether a second word with an address follows the opcode. */
    boolean isLong() {
        return this == LDS || this == STS || this == JMP || this == CALL;
    }
}
