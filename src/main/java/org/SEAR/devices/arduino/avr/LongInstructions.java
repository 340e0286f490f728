// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Locale;

/** Executes the instructions of two and more cycles. Cycles are those of the AVR Instruction Set Manual, AVRe+ core. */
abstract class LongInstructions extends Avr {
    private static final int X = 26;
    private static final int Y = 28;
    private static final int Z = 30;
    private static final int BYTE = 0xFF;
    private static final int BITS = 8;
    private static final int IO = 0x20;
    private static final int PC_MASK = FLASH_WORDS - 1;

    LongInstructions(Surroundings surroundings) {
        super(surroundings);
    }

    final int word(int low) {
        return data[low] & BYTE | (data[low + 1] & BYTE) << BITS;
    }

    final void setWord(int low, int value) {
        data[low] = (byte) value;
        data[low + 1] = (byte) (value >> BITS);
    }

    /** Register d of five bits. */
    static int d(int opcode) {
        return opcode >> 4 & 31;
    }

    /** Register r of five bits. */
    static int r(int opcode) {
        return opcode & 15 | opcode >> 5 & 16;
    }

    /** Register d of the upper half. */
    static int upper(int opcode) {
        return opcode >> 4 & 15 | 16;
    }

    static int k(int opcode) {
        return opcode >> 4 & 0xF0 | opcode & 15;
    }

    static int q(int opcode) {
        return opcode & 7 | opcode >> 7 & 0x18 | opcode >> 8 & 0x20;
    }

    static int ioBitAddress(int opcode) {
        return (opcode >> 3 & 31) + IO;
    }

    final int dValue(int opcode) {
        return data[d(opcode)] & BYTE;
    }

    final int rValue(int opcode) {
        return data[r(opcode)] & BYTE;
    }

    final void setD(int opcode, int value) {
        data[d(opcode)] = (byte) value;
    }

    final int nextWord() {
        int word = flash[pc];
        pc = pc + 1 & PC_MASK;
        return word;
    }

    final void branch(int opcode, boolean taken) {
        if (taken) {
            pc = pc + (opcode << 22 >> 25) & PC_MASK;
            cycle++;
        }
    }

    final void skip(boolean skipped) {
        if (skipped) {
            int words = code[pc].isLong() ? 2 : 1;
            pc = pc + words & PC_MASK;
            cycle += words;
        }
    }

    /** Executes an instruction of two or more cycles; two are counted already. */
    final void executeLonger(Instruction instruction, int opcode) {
        switch (instruction) {
            case LDD_Y:
                setD(opcode, read(word(Y) + q(opcode)));
                break;
            case LDD_Z:
                setD(opcode, read(word(Z) + q(opcode)));
                break;
            case STD_Y:
                write(word(Y) + q(opcode), dValue(opcode));
                break;
            case STD_Z:
                write(word(Z) + q(opcode), dValue(opcode));
                break;
            case LDS:
                setD(opcode, read(nextWord()));
                break;
            case STS:
                write(nextWord(), dValue(opcode));
                break;
            case LD_X:
                setD(opcode, read(word(X)));
                break;
            case LD_X_INC:
                load(opcode, X);
                break;
            case LD_Y_INC:
                load(opcode, Y);
                break;
            case LD_Z_INC:
                load(opcode, Z);
                break;
            case LD_DEC_X:
                setD(opcode, read(before(X)));
                break;
            case LD_DEC_Y:
                setD(opcode, read(before(Y)));
                break;
            case LD_DEC_Z:
                setD(opcode, read(before(Z)));
                break;
            case ST_X:
                write(word(X), dValue(opcode));
                break;
            case ST_X_INC:
                store(opcode, X);
                break;
            case ST_Y_INC:
                store(opcode, Y);
                break;
            case ST_Z_INC:
                store(opcode, Z);
                break;
            case ST_DEC_X:
                write(before(X), dValue(opcode));
                break;
            case ST_DEC_Y:
                write(before(Y), dValue(opcode));
                break;
            case ST_DEC_Z:
                write(before(Z), dValue(opcode));
                break;
            case PUSH:
                push(dValue(opcode));
                break;
            case POP:
                setD(opcode, pop());
                break;
            default:
                executeWords(instruction, opcode);
                break;
        }
    }

    /** Executes an instruction of two or more cycles that is neither a load nor a store. */
    private void executeWords(Instruction instruction, int opcode) {
        switch (instruction) {
            case ADIW:
                int up = X - 2 + (opcode >> 3 & 6);
                setWord(up, alu.addWord(word(up), opcode >> 2 & 0x30 | opcode & 15));
                break;
            case SBIW:
                int down = X - 2 + (opcode >> 3 & 6);
                setWord(down, alu.subWord(word(down), opcode >> 2 & 0x30 | opcode & 15));
                break;
            case SBI:
                setBit(ioBitAddress(opcode), opcode & 7);
                break;
            case CBI:
                write(ioBitAddress(opcode), read(ioBitAddress(opcode)) & ~(1 << (opcode & 7)));
                break;
            case SBIC:
                cycle--;
                skip((read(ioBitAddress(opcode)) >> (opcode & 7) & 1) == 0);
                break;
            case SBIS:
                cycle--;
                skip((read(ioBitAddress(opcode)) >> (opcode & 7) & 1) != 0);
                break;
            case IJMP:
                pc = word(Z) & PC_MASK;
                break;
            case MUL:
                setWord(0, alu.product(dValue(opcode) * rValue(opcode), 0));
                break;
            case MULS:
                setWord(0, alu.product(data[upper(opcode)] * data[opcode & 15 | 16] & 0xFFFF, 0));
                break;
            case MULSU:
            case FMULSU:
                setWord(0, alu.product(data[opcode >> 4 & 7 | 16] * (data[opcode & 7 | 16] & BYTE) & 0xFFFF,
                    instruction == Instruction.FMULSU ? 1 : 0));
                break;
            case FMUL:
                setWord(0, alu.product((data[opcode >> 4 & 7 | 16] & BYTE) * (data[opcode & 7 | 16] & BYTE), 1));
                break;
            case FMULS:
                setWord(0, alu.product(data[opcode >> 4 & 7 | 16] * data[opcode & 7 | 16] & 0xFFFF, 1));
                break;
            default:
                cycle++;
                executeLongest(instruction, opcode);
                break;
        }
    }

    private void load(int opcode, int pointer) {
        int address = word(pointer);
        setWord(pointer, address + 1);
        setD(opcode, read(address));
    }

    private void store(int opcode, int pointer) {
        int address = word(pointer);
        int value = dValue(opcode);
        setWord(pointer, address + 1);
        write(address, value);
    }

    private int before(int pointer) {
        setWord(pointer, word(pointer) - 1);
        return word(pointer);
    }

    private int program(int address) {
        return flash[address >> 1 & PC_MASK] >> (address & 1) * BITS & BYTE;
    }

    /** Executes an instruction of three or more cycles, of which three are counted already, or a rare one. */
    private void executeLongest(Instruction instruction, int opcode) {
        switch (instruction) {
            case LPM:
                setD(opcode, program(word(Z)));
                break;
            case LPM_INC:
                int address = word(Z);
                setWord(Z, address + 1);
                setD(opcode, program(address));
                break;
            case LPM_R0:
                data[0] = (byte) program(word(Z));
                break;
            case JMP:
                pc = nextWord() & PC_MASK;
                break;
            case CALL:
                int target = nextWord();
                pushPc(pc);
                pc = target & PC_MASK;
                cycle++;
                break;
            case RCALL:
                pushPc(pc);
                pc = pc + (opcode << 20 >> 20) & PC_MASK;
                break;
            case ICALL:
                pushPc(pc);
                pc = word(Z) & PC_MASK;
                break;
            case RET:
                pc = popPc();
                cycle++;
                break;
            case RETI:
                pc = popPc();
                cycle++;
                alu.sreg |= Alu.I;
                delayed = true;
                break;
            case SLEEP:
                cycle -= 2;
                sleep();
                break;
            case WDR:
                cycle -= 2;
                watchdogReset();
                break;
            case BREAK:
                cycle -= 2;
                break;
            default:
                cycle -= 2;
                if (!isFirst(pc - 1 & PC_MASK)) {
                    break;
                }
                reportAt(pc - 1 & PC_MASK, String.format(Locale.ROOT,
                    "executes 0x%04X (%s), which an ATmega328P does not support here: did it jump out of its code?",
                    opcode, instruction == Instruction.RESERVED ? "no instruction" : instruction));
                break;
        }
    }

    /** Restarts the time of the watchdog. */
    abstract void watchdogReset();
}
