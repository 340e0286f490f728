// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;

/**
 * Memory, registers, interrupts and clock of an ATmega328P. The CPU executes one instruction at a time; peripherals act
 * at the cycles that they ask for. While the CPU sleeps, the clock jumps from event to event.
 */
abstract class Avr {
    static final int FLASH_WORDS = 0x4000;
    static final int RAM_START = 0x100;
    static final int MEMORY = 0x900;
    static final long NEVER = Long.MAX_VALUE;
    private static final int VECTORS = 26;
    private static final int VECTOR_WORDS = 2;
    private static final int INTERRUPT_CYCLES = 4;
    private static final int IO_START = 0x20;
    private static final int SPL = 0x5D;
    private static final int SPH = 0x5E;
    private static final int SREG = 0x5F;
    private static final int SMCR = 0x53;
    private static final int BYTE = 0xFF;
    private static final int BITS = 8;
    /** Reports per power-on; a program that has jumped into its data would make thousands. */
    private static final int MOST_REPORTS = 20;

    /** Part of the chip that acts at certain cycles. */
    interface Peripheral {
        /** Returns the cycle of its next action, {@link #NEVER} for none. */
        long next();

        /** Acts; the clock is at {@link #next} or later. */
        void act();

        /** Sets the state after a reset. */
        void reset();
    }

    final byte[] data = new byte[MEMORY];
    final int[] flash = new int[FLASH_WORDS];
    final Instruction[] code = new Instruction[FLASH_WORDS];
    final Alu alu = new Alu();
    final Surroundings surroundings;
    int pc;
    int sp;
    /** Cycles since power-on. */
    long cycle;
    boolean sleeping;
    /** Whether one more instruction runs before the next interrupt, as after SEI and RETI. */
    boolean delayed;
    private final Register[] registers = new Register[RAM_START];
    private final Peripheral[] peripherals;
    private int peripheralCount;
    private final Runnable[] acknowledges = new Runnable[VECTORS];
    private final Set<String> reported = new HashSet<>();
    /** Instructions and registers about which something was reported. */
    private final BitSet reportedPlaces = new BitSet(FLASH_WORDS + MEMORY);
    private long nextEvent = NEVER;
    private int raised;

    Avr(Surroundings surroundings) {
        this.surroundings = surroundings;
        peripherals = new Peripheral[BITS * 2];
        Register cpu = new CpuRegisters();
        map(cpu, SPL, SPH, SREG);
    }

    final void map(Register register, int... addresses) {
        for (int address : addresses) {
            registers[address] = register;
        }
    }

    final void add(Peripheral peripheral) {
        peripherals[peripheralCount++] = peripheral;
    }

    /** @param acknowledge runs when the CPU starts the interrupt, to clear its flag */
    final void onInterrupt(int vector, Runnable acknowledge) {
        acknowledges[vector] = acknowledge;
    }

    /** Sets whether an interrupt is both flagged and enabled. */
    final void raise(int vector, boolean on) {
        raised = on ? raised | 1 << vector : raised & ~(1 << vector);
    }

    /** Finds the next event again, after a peripheral has changed its own. */
    final void schedule() {
        long next = NEVER;
        for (int i = 0; i < peripheralCount; i++) {
            next = Math.min(next, peripherals[i].next());
        }
        nextEvent = next;
    }

    /** Resets CPU and peripherals; SRAM and the clock keep their values. */
    final void restart() {
        pc = 0;
        sp = MEMORY - 1;
        alu.sreg = 0;
        sleeping = false;
        delayed = false;
        raised = 0;
        Arrays.fill(data, 0, RAM_START, (byte) 0);
        for (int i = 0; i < peripheralCount; i++) {
            peripherals[i].reset();
        }
        schedule();
    }

    /** Forgets which causes were reported. */
    final void forgetReports() {
        reported.clear();
        reportedPlaces.clear();
    }

    final void report(String message) {
        if (reported.size() < MOST_REPORTS && reported.add(message)) {
            surroundings.report(message);
        }
    }

    /** Whether nothing was reported at an instruction, or at a register plus {@link #FLASH_WORDS}; notes the report. */
    final boolean isFirst(int place) {
        boolean first = !reportedPlaces.get(place);
        reportedPlaces.set(place);
        return first;
    }

    final void reportAt(int place, String message) {
        report(String.format(Locale.ROOT, "at address 0x%04X the program %s", place * 2, message));
    }

    /** Runs up to a cycle; the last instruction may end some cycles later. */
    final void runUntil(long end) {
        while (cycle < end) {
            while (cycle >= nextEvent) {
                act();
            }
            if (raised != 0 && !delayed) {
                if ((alu.sreg & Alu.I) != 0) {
                    interrupt();
                }
            }
            delayed = false;
            if (sleeping) {
                cycle = Math.max(cycle, Math.min(end, nextEvent));
            } else {
                execute();
            }
        }
    }

    private void act() {
        for (int i = 0; i < peripheralCount; i++) {
            if (peripherals[i].next() <= cycle) {
                peripherals[i].act();
            }
        }
        schedule();
    }

    /** Executes one instruction and adds its cycles. */
    abstract void execute();

    private void interrupt() {
        int vector = Integer.numberOfTrailingZeros(raised);
        if (acknowledges[vector] != null) {
            acknowledges[vector].run();
        }
        sleeping = false;
        pushPc(pc);
        alu.sreg &= ~Alu.I;
        pc = vector * VECTOR_WORDS;
        cycle += INTERRUPT_CYCLES;
    }

    final void pushPc(int address) {
        push(address & BYTE);
        push(address >> BITS);
    }

    final int popPc() {
        int high = pop();
        return (high << BITS | pop()) & FLASH_WORDS - 1;
    }

    final void push(int value) {
        write(sp, value);
        sp = sp - 1 & 0xFFFF;
    }

    final int pop() {
        sp = sp + 1 & 0xFFFF;
        return read(sp);
    }

    final int read(int address) {
        if (address >= RAM_START || address < IO_START) {
            return address < MEMORY ? data[address] & BYTE : outside(address, "reads");
        }
        Register register = registers[address];
        return register != null ? register.read(address) : unknown(address);
    }

    final void write(int address, int value) {
        if (address >= RAM_START || address < IO_START) {
            if (address < MEMORY) {
                data[address] = (byte) value;
            } else {
                outside(address, "writes");
            }
            return;
        }
        Register register = registers[address];
        if (register != null) {
            register.write(address, value);
        } else {
            unknown(address);
            data[address] = (byte) value;
        }
    }

    final void setBit(int address, int bit) {
        Register register = registers[address];
        if (register != null) {
            register.setBit(address, bit);
        } else {
            write(address, read(address) | 1 << bit);
        }
    }

    private int outside(int address, String verb) {
        if (isFirst(pc)) {
            reportAt(pc, String.format(Locale.ROOT, "%s data address 0x%04X; legal: 0 to 0x%04X", verb, address,
                MEMORY - 1));
        }
        return BYTE;
    }

    private int unknown(int address) {
        if (isFirst(FLASH_WORDS + address)) {
            report(RegisterNames.of(address) + " is not simulated; the program reads there what it wrote");
        }
        return data[address] & BYTE;
    }

    /** Enters the sleep mode if it is enabled. All modes stop only the CPU. */
    final void sleep() {
        sleeping = (data[SMCR] & 1) != 0;
    }

    /** Stack pointer and status register. */
    private final class CpuRegisters implements Register {
        @Override
        public int read(int address) {
            return address == SREG ? alu.sreg : address == SPL ? sp & BYTE : sp >> BITS;
        }

        @Override
        public void write(int address, int value) {
            if (address == SREG) {
                delayed = (value & ~alu.sreg & Alu.I) != 0;
                alu.sreg = value;
            } else {
                sp = address == SPL ? sp & ~BYTE | value : sp & BYTE | value << BITS;
            }
        }
    }
}
