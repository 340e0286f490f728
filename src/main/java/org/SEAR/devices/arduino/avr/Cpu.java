// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** Executes the instructions of one cycle. Cycles are those of the AVR Instruction Set Manual, AVRe+ core. */
abstract class Cpu extends LongInstructions {
    private static final int BYTE = 0xFF;
    private static final int IO = 0x20;
    private static final int PC_MASK = FLASH_WORDS - 1;

    Cpu(Surroundings surroundings) {
        super(surroundings);
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
            default:
                executeBits(instruction, opcode);
                break;
        }
    }

    /** Executes an instruction on one register, its bits or an I/O register. */
    private void executeBits(Instruction instruction, int opcode) {
        switch (instruction) {
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
}
