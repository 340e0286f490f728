// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Locale;

/** Executes instructions. Cycles are those of the AVR Instruction Set Manual for the AVRe+ core. */
abstract class Cpu extends Avr {
    private static final int X = 26;
    private static final int Y = 28;
    private static final int Z = 30;
    private static final int BYTE = 0xFF;
    private static final int BITS = 8;
    private static final int IO = 0x20;
    private static final int PC_MASK = FLASH_WORDS - 1;

    Cpu(Surroundings surroundings) {
        super(surroundings);
    }

    private int word(int low) {
        return data[low] & BYTE | (data[low + 1] & BYTE) << BITS;
    }

    private void setWord(int low, int value) {
        data[low] = (byte) value;
        data[low + 1] = (byte) (value >> BITS);
    }

    /** Register d of five bits. */
    private static int d(int opcode) {
        return opcode >> 4 & 31;
    }

    /** Register r of five bits. */
    private static int r(int opcode) {
        return opcode & 15 | opcode >> 5 & 16;
    }

    /** Register d of the upper half. */
    private static int upper(int opcode) {
        return opcode >> 4 & 15 | 16;
    }

    private static int k(int opcode) {
        return opcode >> 4 & 0xF0 | opcode & 15;
    }

    private static int q(int opcode) {
        return opcode & 7 | opcode >> 7 & 0x18 | opcode >> 8 & 0x20;
    }

    private static int ioBitAddress(int opcode) {
        return (opcode >> 3 & 31) + IO;
    }

    private int dValue(int opcode) {
        return data[d(opcode)] & BYTE;
    }

    private int rValue(int opcode) {
        return data[r(opcode)] & BYTE;
    }

    private void setD(int opcode, int value) {
        data[d(opcode)] = (byte) value;
    }

    private int nextWord() {
        int word = flash[pc];
        pc = pc + 1 & PC_MASK;
        return word;
    }

    @Override
    final void execute() {
        int opcode = flash[pc];
        Instruction instruction = code[pc];
        pc = pc + 1 & PC_MASK;
        cycle++;
        switch (instruction) {
            case NOP:
                break;
            case MOV:
                setD(opcode, rValue(opcode));
                break;
            case MOVW:
                setWord((opcode >> 4 & 15) * 2, word((opcode & 15) * 2));
                break;
            case LDI:
                data[upper(opcode)] = (byte) k(opcode);
                break;
            case ADD:
                setD(opcode, alu.add(dValue(opcode), rValue(opcode), 0));
                break;
            case ADC:
                setD(opcode, alu.add(dValue(opcode), rValue(opcode), alu.sreg & Alu.C));
                break;
            case SUB:
                setD(opcode, alu.sub(dValue(opcode), rValue(opcode)));
                break;
            case SBC:
                setD(opcode, alu.subCarry(dValue(opcode), rValue(opcode)));
                break;
            case CP:
                alu.sub(dValue(opcode), rValue(opcode));
                break;
            case CPC:
                alu.subCarry(dValue(opcode), rValue(opcode));
                break;
            case CPI:
                alu.sub(data[upper(opcode)] & BYTE, k(opcode));
                break;
            case SUBI:
                data[upper(opcode)] = (byte) alu.sub(data[upper(opcode)] & BYTE, k(opcode));
                break;
            case SBCI:
                data[upper(opcode)] = (byte) alu.subCarry(data[upper(opcode)] & BYTE, k(opcode));
                break;
            case AND:
                setD(opcode, alu.logic(dValue(opcode) & rValue(opcode)));
                break;
            case OR:
                setD(opcode, alu.logic(dValue(opcode) | rValue(opcode)));
                break;
            case EOR:
                setD(opcode, alu.logic(dValue(opcode) ^ rValue(opcode)));
                break;
            case ANDI:
                data[upper(opcode)] = (byte) alu.logic(data[upper(opcode)] & k(opcode));
                break;
            case ORI:
                data[upper(opcode)] = (byte) alu.logic(data[upper(opcode)] & BYTE | k(opcode));
                break;
            case BRBS:
                branch(opcode, (alu.sreg >> (opcode & 7) & 1) != 0);
                break;
            case BRBC:
                branch(opcode, (alu.sreg >> (opcode & 7) & 1) == 0);
                break;
            case RJMP:
                pc = pc + (opcode << 20 >> 20) & PC_MASK;
                cycle++;
                break;
            case IN:
                setD(opcode, read((opcode & 15 | opcode >> 5 & 0x30) + IO));
                break;
            case OUT:
                write((opcode & 15 | opcode >> 5 & 0x30) + IO, dValue(opcode));
                break;
            case INC:
                setD(opcode, alu.inc(dValue(opcode)));
                break;
            case DEC:
                setD(opcode, alu.dec(dValue(opcode)));
                break;
            case COM:
                setD(opcode, alu.com(dValue(opcode)));
                break;
            case NEG:
                setD(opcode, alu.sub(0, dValue(opcode)));
                break;
            case SWAP:
                setD(opcode, dValue(opcode) >> 4 | dValue(opcode) << 4);
                break;
            case ASR:
                setD(opcode, alu.shiftRight(dValue(opcode), dValue(opcode) >> 7));
                break;
            case LSR:
                setD(opcode, alu.shiftRight(dValue(opcode), 0));
                break;
            case ROR:
                setD(opcode, alu.shiftRight(dValue(opcode), alu.sreg & Alu.C));
                break;
            case CPSE:
                skip(dValue(opcode) == rValue(opcode));
                break;
            case SBRC:
                skip((dValue(opcode) >> (opcode & 7) & 1) == 0);
                break;
            case SBRS:
                skip((dValue(opcode) >> (opcode & 7) & 1) != 0);
                break;
            case BST:
                alu.sreg = alu.sreg & ~Alu.T | (dValue(opcode) >> (opcode & 7) & 1) * Alu.T;
                break;
            case BLD:
                int bit = 1 << (opcode & 7);
                setD(opcode, (alu.sreg & Alu.T) != 0 ? dValue(opcode) | bit : dValue(opcode) & ~bit);
                break;
            case BSET:
                delayed = (1 << (opcode >> 4 & 7) & ~alu.sreg & Alu.I) != 0;
                alu.sreg |= 1 << (opcode >> 4 & 7);
                break;
            case BCLR:
                alu.sreg &= ~(1 << (opcode >> 4 & 7));
                break;
            default:
                cycle++;
                executeLonger(instruction, opcode);
                break;
        }
    }

    private void branch(int opcode, boolean taken) {
        if (taken) {
            pc = pc + (opcode << 22 >> 25) & PC_MASK;
            cycle++;
        }
    }

    private void skip(boolean skipped) {
        if (skipped) {
            int words = code[pc].isLong() ? 2 : 1;
            pc = pc + words & PC_MASK;
            cycle += words;
        }
    }

    /** Executes an instruction of two or more cycles; two are counted already. */
    private void executeLonger(Instruction instruction, int opcode) {
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
                reportAt(pc - 1 & PC_MASK, String.format(Locale.ROOT,
                    "executes 0x%04X (%s), which an ATmega328P does not support here: did it jump out of its code?",
                    opcode, instruction == Instruction.RESERVED ? "no instruction" : instruction));
                break;
        }
    }

    /** Restarts the time of the watchdog. */
    abstract void watchdogReset();
}
