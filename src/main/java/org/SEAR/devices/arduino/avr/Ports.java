// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Arrays;

/**
 * Ports B, C and D with external and pin-change interrupts. Timers can drive pins instead of PORTx. Source: data sheet,
 * sections 13 and 14. Pins are numbered port * 8 + bit from port B = 0.
 */
final class Ports implements Register, Avr.Peripheral {
    static final int PORTS = 3;
    private static final int BITS = 8;
    private static final int FIRST = 0x23;
    private static final int PCIFR = 0x3B;
    private static final int EIFR = 0x3C;
    private static final int EIMSK = 0x3D;
    private static final int PCICR = 0x68;
    private static final int EICRA = 0x69;
    private static final int PCMSK0 = 0x6B;
    private static final int INT0 = 1;
    private static final int PCINT0 = 3;
    private static final int INT0_BIT = 2;
    private static final int PORT_D = 2;
    private static final int QUEUE = 64;

    private final Avr avr;
    private final int[] ddr = new int[PORTS];
    private final int[] port = new int[PORTS];
    private final int[] timed = new int[PORTS];
    private final int[] timerLevel = new int[PORTS];
    private final int[] outside = new int[PORTS];
    private final int[] floating = new int[PORTS];
    private final int[] seen = new int[PORTS];
    private final int[] pcmsk = new int[PORTS];
    private final Surroundings.Drive[] shown = new Surroundings.Drive[PORTS * BITS];
    private final long[] queueCycles = new long[QUEUE];
    private final int[] queueInputs = new int[QUEUE];
    private int queued;
    private int eicra;
    private int eimsk;
    private int eifr;
    private int pcicr;
    private int pcifr;

    Ports(Avr avr) {
        this.avr = avr;
        for (int i = 0; i < PORTS * PORTS; i++) {
            avr.map(this, FIRST + i);
        }
        avr.map(this, PCIFR, EIFR, EIMSK, PCICR, EICRA, PCMSK0, PCMSK0 + 1, PCMSK0 + 2);
        for (int i = 0; i < 2; i++) {
            int flag = 1 << i;
            avr.onInterrupt(INT0 + i, () -> write(EIFR, flag));
        }
        for (int i = 0; i < PORTS; i++) {
            int flag = 1 << i;
            avr.onInterrupt(PCINT0 + i, () -> write(PCIFR, flag));
        }
        Arrays.fill(floating, 0xFF);
        Arrays.fill(shown, Surroundings.Drive.FLOATING);
        avr.add(this);
    }

    @Override
    public void reset() {
        for (int i = 0; i < PORTS; i++) {
            ddr[i] = port[i] = timed[i] = timerLevel[i] = pcmsk[i] = 0;
        }
        eicra = eimsk = eifr = pcicr = pcifr = 0;
        for (int i = 0; i < PORTS; i++) {
            show(i);
        }
    }

    /** Lets a timer drive a pin, or releases it. */
    void connect(int pin, boolean on) {
        int bit = 1 << pin % BITS;
        int before = timed[pin / BITS];
        timed[pin / BITS] = on ? before | bit : before & ~bit;
        if (timed[pin / BITS] != before) {
            show(pin / BITS);
        }
    }

    /** Sets the level of a timer's output at a cycle, which may be earlier than the end of the present instruction. */
    void drive(int pin, boolean level, long at) {
        int bit = 1 << pin % BITS;
        int index = pin / BITS;
        timerLevel[index] = level ? timerLevel[index] | bit : timerLevel[index] & ~bit;
        if ((timed[index] & bit) != 0) {
            show(index, at);
        }
    }

    boolean driven(int pin) {
        return (timerLevel[pin / BITS] >> pin % BITS & 1) != 0;
    }

    /** Sets the level of a pin, which loses against the pull-up if the circuit does not drive the pin. */
    void input(int pin, boolean high, boolean driven) {
        int bit = 1 << pin % BITS;
        int index = pin / BITS;
        outside[index] = high ? outside[index] | bit : outside[index] & ~bit;
        floating[index] = driven ? floating[index] & ~bit : floating[index] | bit;
        show(index);
    }

    /** Sets the level of a pin at a later cycle. */
    void inputAt(long cycle, int pin, boolean high) {
        if (queued == QUEUE) {
            return;
        }
        int at = queued++;
        while (at > 0 && queueCycles[at - 1] > cycle) {
            queueCycles[at] = queueCycles[at - 1];
            queueInputs[at] = queueInputs[at - 1];
            at--;
        }
        queueCycles[at] = cycle;
        queueInputs[at] = pin * 2 + (high ? 1 : 0);
        avr.schedule();
    }

    void clearQueue() {
        queued = 0;
    }

    @Override
    public long next() {
        return queued > 0 ? queueCycles[0] : Avr.NEVER;
    }

    @Override
    public void act() {
        int input = queueInputs[0];
        queued--;
        System.arraycopy(queueCycles, 1, queueCycles, 0, queued);
        System.arraycopy(queueInputs, 1, queueInputs, 0, queued);
        input(input / 2, input % 2 != 0, true);
    }

    private int outputs(int index) {
        return port[index] & ~timed[index] | timerLevel[index] & timed[index];
    }

    private int levels(int index) {
        int open = floating[index] & port[index] | outside[index];
        return outputs(index) & ddr[index] | open & ~ddr[index];
    }

    /** Reports changed outputs, and raises the interrupts of changed levels. */
    private void show(int index) {
        show(index, avr.cycle);
    }

    private void show(int index, long at) {
        for (int bit = 0; bit < BITS; bit++) {
            boolean high = (outputs(index) >> bit & 1) != 0;
            Surroundings.Drive now = (ddr[index] >> bit & 1) != 0
                ? high ? Surroundings.Drive.HIGH : Surroundings.Drive.LOW
                : (port[index] >> bit & 1) != 0 ? Surroundings.Drive.PULLUP : Surroundings.Drive.FLOATING;
            if (shown[index * BITS + bit] != now) {
                shown[index * BITS + bit] = now;
                avr.surroundings.output(index, bit, now, at);
            }
        }
        int now = levels(index);
        int changed = now ^ seen[index];
        seen[index] = now;
        if (changed == 0) {
            return;
        }
        if ((changed & pcmsk[index]) != 0) {
            pcifr |= 1 << index;
        }
        for (int i = 0; index == PORT_D && i < 2; i++) {
            int bit = INT0_BIT + i;
            int sense = eicra >> 2 * i & 3;
            if ((changed >> bit & 1) != 0 && (sense == 1 || sense >= 2 && (now >> bit & 1) == sense - 2)) {
                eifr |= 1 << i;
            }
        }
        raise();
    }

    private void raise() {
        for (int i = 0; i < 2; i++) {
            boolean low = (eicra >> 2 * i & 3) == 0 && (seen[PORT_D] >> INT0_BIT + i & 1) == 0;
            avr.raise(INT0 + i, (eimsk >> i & 1) != 0 && (low || (eifr >> i & 1) != 0));
        }
        for (int i = 0; i < PORTS; i++) {
            avr.raise(PCINT0 + i, (pcicr & pcifr & 1 << i) != 0);
        }
    }

    @Override
    public int read(int address) {
        switch (address) {
            case PCIFR:
                return pcifr;
            case EIFR:
                return eifr;
            case EIMSK:
                return eimsk;
            case PCICR:
                return pcicr;
            case EICRA:
                return eicra;
            default:
                if (address >= PCMSK0) {
                    return pcmsk[address - PCMSK0];
                }
                int index = (address - FIRST) / PORTS;
                int kind = (address - FIRST) % PORTS;
                return kind == 0 ? levels(index) : kind == 1 ? ddr[index] : port[index];
        }
    }

    @Override
    public void write(int address, int value) {
        switch (address) {
            case PCIFR:
                pcifr &= ~value;
                break;
            case EIFR:
                eifr &= ~value;
                break;
            case EIMSK:
                eimsk = value;
                break;
            case PCICR:
                pcicr = value;
                break;
            case EICRA:
                eicra = value;
                break;
            default:
                if (address >= PCMSK0) {
                    pcmsk[address - PCMSK0] = value;
                    break;
                }
                int index = (address - FIRST) / PORTS;
                int kind = (address - FIRST) % PORTS;
                if (kind == 1) {
                    ddr[index] = value;
                } else {
                    port[index] = kind == 0 ? port[index] ^ value : value;
                }
                show(index);
                break;
        }
        raise();
    }

    @Override
    public void setBit(int address, int bit) {
        boolean alone = address == PCIFR || address == EIFR
            || address < FIRST + PORTS * PORTS && (address - FIRST) % PORTS == 0;
        write(address, alone ? 1 << bit : read(address) | 1 << bit);
    }
}
