// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/**
 * Arithmetic logic unit: results of 8-bit operations and the status register. Source of each flag: the Boolean formulas
 * of the AVR Instruction Set Manual.
 */
final class Alu {
    static final int C = 1;
    static final int Z = 2;
    static final int N = 4;
    static final int V = 8;
    static final int S = 16;
    static final int H = 32;
    static final int T = 64;
    static final int I = 128;
    private static final int BYTE = 0xFF;
    private static final int WORD = 0xFFFF;
    private static final int SIGN = 7;
    private static final int WORD_SIGN = 15;
    private static final int HALF = 3;

    /** Status register. */
    int sreg;

    int add(int a, int b, int carry) {
        int result = a + b + carry & BYTE;
        int carries = a & b | (a | b) & ~result;
        set(carries, result, (a ^ result) & (b ^ result));
        return result;
    }

    /** Subtracts without carry; sets all flags. */
    int sub(int a, int b) {
        int result = a - b & BYTE;
        set(~a & b | (~a | b) & result, result, (a ^ b) & (a ^ result));
        return result;
    }

    /** Subtracts with carry; clears Z for a result other than 0 but never sets it. */
    int subCarry(int a, int b) {
        int zero = sreg & Z;
        int result = a - b - (sreg & C) & BYTE;
        set(~a & b | (~a | b) & result, result, (a ^ b) & (a ^ result));
        sreg = sreg & ~Z | (result == 0 ? zero : 0);
        return result;
    }

    /** Sets C and H by bits 7 and 3 of the carries, V by bit 7 of the overflow, and Z, N, S. */
    private void set(int carries, int result, int overflow) {
        int flags = sreg & (I | T) | carries >> SIGN & C | (carries >> HALF & 1) * H;
        sreg = flags | signs(result, overflow >> SIGN & 1);
    }

    private static int signs(int result, int v) {
        int n = result >> SIGN & 1;
        return (result == 0 ? Z : 0) | n * N | v * V | (n ^ v) * S;
    }

    int logic(int result) {
        sreg = sreg & (I | T | H | C) | signs(result, 0);
        return result;
    }

    int com(int a) {
        int result = ~a & BYTE;
        sreg = sreg & (I | T | H) | signs(result, 0) | C;
        return result;
    }

    int inc(int a) {
        int result = a + 1 & BYTE;
        sreg = sreg & (I | T | H | C) | signs(result, result == 0x80 ? 1 : 0);
        return result;
    }

    int dec(int a) {
        int result = a - 1 & BYTE;
        sreg = sreg & (I | T | H | C) | signs(result, result == 0x7F ? 1 : 0);
        return result;
    }

    /** Shifts right by one; the lowest bit becomes the carry. */
    int shiftRight(int a, int highest) {
        int result = a >> 1 | highest << SIGN;
        int carry = a & 1;
        sreg = sreg & (I | T | H) | carry | signs(result, highest ^ carry);
        return result;
    }

    int addWord(int a, int b) {
        int result = a + b & WORD;
        word(result, ~a & result, ~result & a);
        return result;
    }

    int subWord(int a, int b) {
        int result = a - b & WORD;
        word(result, a & ~result, result & ~a);
        return result;
    }

    private void word(int result, int overflow, int carry) {
        int n = result >> WORD_SIGN;
        int v = overflow >> WORD_SIGN & 1;
        sreg = sreg & (I | T | H) | (result == 0 ? Z : 0) | n * N | v * V | (n ^ v) * S | carry >> WORD_SIGN & C;
    }

    /** @param fraction 1 for a fractional multiplication, which shifts the product left, else 0 */
    int product(int factors, int fraction) {
        int result = factors << fraction & WORD;
        sreg = sreg & ~(Z | C) | (result == 0 ? Z : 0) | factors >> WORD_SIGN & C;
        return result;
    }
}
