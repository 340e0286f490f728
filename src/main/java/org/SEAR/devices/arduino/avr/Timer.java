// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/**
 * Timer/counter 0, 1 or 2 with two compare units. Source: data sheet, sections 15 to 18. A flag and the output change
 * at the timer clock after the match. Without prescaler reset; without clocks at a pin, input capture and FOC bits.
 */
final class Timer implements Register, Avr.Peripheral {
    private static final int[] PRESCALERS = {0, 1, 8, 64, 256, 1024, 0, 0};
    private static final int[] PRESCALERS_2 = {0, 1, 8, 32, 64, 128, 256, 1024};
    private static final int BYTE = 0xFF;
    private static final int BITS = 8;
    private static final int OVF = 1;
    private static final int[] FIXED_TOP = {0xFF, 0x1FF, 0x3FF};

    private enum Mode { NORMAL, CTC, FAST, PHASE }

    private final Avr avr;
    private final Ports ports;
    private final boolean wide;
    private final boolean second;
    private final int base;
    private final int tifr;
    private final int[] vectors;
    private final int[] pins;
    private final int max;
    private final int[] compare = new int[2];
    private final int[] buffer = new int[2];
    private Mode mode;
    private int top;
    private int icr;
    private int tccra;
    private int tccrb;
    private int mask;
    private int flags;
    private int count;
    private boolean up;
    private int high;
    private int prescaler;
    private long tick;
    private long next;

    /**
     * @param base address of TCCRnA
     * @param vectors of compare A, compare B and overflow
     * @param pins of compare A and B, port * 8 + bit
     */
    Timer(Avr avr, Ports ports, int number, int base, int[] vectors, int... pins) {
        this.avr = avr;
        this.ports = ports;
        this.wide = number == 1;
        this.second = number == 2;
        this.base = base;
        this.tifr = 0x35 + number;
        this.vectors = vectors;
        this.pins = pins;
        this.max = wide ? 0xFFFF : BYTE;
        avr.map(this, tifr, 0x6E + number);
        for (int i = 0; i < (wide ? 12 : 5); i++) {
            avr.map(this, base + i);
        }
        avr.onInterrupt(vectors[0], () -> clear(2));
        avr.onInterrupt(vectors[1], () -> clear(4));
        avr.onInterrupt(vectors[2], () -> clear(OVF));
        avr.add(this);
    }

    @Override
    public void reset() {
        compare[0] = compare[1] = buffer[0] = buffer[1] = 0;
        icr = tccra = tccrb = mask = flags = count = high = prescaler = 0;
        up = true;
        configure();
        next = Avr.NEVER;
    }

    private void clear(int flag) {
        flags &= ~flag;
        raise();
    }

    private void raise() {
        int on = flags & mask;
        avr.raise(vectors[0], (on & 2) != 0);
        avr.raise(vectors[1], (on & 4) != 0);
        avr.raise(vectors[2], (on & OVF) != 0);
    }

    private void configure() {
        int wgm = tccra & 3 | tccrb >> 1 & (wide ? 12 : 4);
        top = max;
        if (wide) {
            boolean fixed = wgm < 8 && (wgm & 3) != 0;
            mode = wgm == 0 ? Mode.NORMAL : wgm == 4 || wgm == 12 ? Mode.CTC : wgm >= 5 && wgm <= 7 || wgm >= 14
                ? Mode.FAST : Mode.PHASE;
            top = wgm == 0 ? max : fixed ? FIXED_TOP[(wgm & 3) - 1] : wgm == 4 || wgm > 8 && (wgm & 1) != 0
                ? compare[0] : icr;
        } else {
            mode = wgm == 2 ? Mode.CTC : (wgm & 3) == 3 ? Mode.FAST : (wgm & 3) == 1 ? Mode.PHASE : Mode.NORMAL;
            top = wgm == 2 || wgm == 5 || wgm == 7 ? compare[0] : max;
        }
        if (mode != Mode.PHASE) {
            up = true;
        }
        for (int i = 0; i < 2; i++) {
            ports.connect(pins[i], connects(i));
        }
    }

    private int com(int unit) {
        return tccra >> 6 - 2 * unit & 3;
    }

    /** Whether a unit drives its pin. A toggling PWM output exists only in unit A and with OCRnA as TOP. */
    private boolean connects(int unit) {
        boolean pwm = mode == Mode.FAST || mode == Mode.PHASE;
        return com(unit) > 1 || com(unit) == 1 && (!pwm || unit == 0 && top == compare[0]);
    }

    private boolean buffered() {
        return mode == Mode.FAST || mode == Mode.PHASE;
    }

    /** Counts up to the present cycle. */
    private void sync() {
        if (prescaler == 0) {
            return;
        }
        long now = avr.cycle / prescaler;
        while (tick < now) {
            int distance = distance();
            if (distance >= now - tick) {
                count += (int) (up ? now - tick : tick - now);
                tick = now;
            } else {
                count += up ? distance : -distance;
                tick += distance + 1;
                leave();
            }
        }
    }

    /** Ticks until the count is at a compare value or an end of its range; it leaves this value one tick later. */
    private int distance() {
        int end = up ? (mode == Mode.NORMAL || count > top ? max : top) - count : Math.max(0, count - 1);
        for (int i = 0; i < 2; i++) {
            int ahead = up ? compare[i] - count : count - compare[i];
            if (ahead >= 0 && ahead < end) {
                end = ahead;
            }
        }
        return end;
    }

    private void leave() {
        int from = count;
        for (int i = 0; i < 2; i++) {
            if (from == compare[i]) {
                flags |= 2 << i;
                match(i);
            }
        }
        if (mode == Mode.PHASE) {
            leavePhase(from);
        } else if (from == max || from == top && mode != Mode.NORMAL) {
            count = 0;
            if (from == max || mode == Mode.FAST) {
                flags |= OVF;
            }
            if (mode == Mode.FAST) {
                load();
                for (int i = 0; i < 2; i++) {
                    if (com(i) > 1) {
                        ports.drive(pins[i], com(i) == 2, tick * prescaler);
                    }
                }
            }
        } else {
            count = from + 1;
        }
        raise();
    }

    private void leavePhase(int from) {
        if (up && from >= top) {
            up = false;
            load();
        }
        count = Math.max(0, up ? from + 1 : from - 1);
        if (count == 0) {
            up = true;
            flags |= OVF;
        } else if (up && count >= top) {
            up = false;
            load();
        }
    }

    private void load() {
        compare[0] = buffer[0];
        compare[1] = buffer[1];
        configure();
    }

    private void match(int unit) {
        int com = com(unit);
        if (com == 1) {
            ports.drive(pins[unit], !ports.driven(pins[unit]), tick * prescaler);
        } else if (com > 1) {
            boolean set = mode == Mode.PHASE && (!up || count >= top);
            ports.drive(pins[unit], (mode == Mode.PHASE || mode == Mode.FAST) ? set == (com == 2) : com == 3,
                tick * prescaler);
        }
    }

    private void plan() {
        boolean matters = prescaler > 0 && (mask != 0 || connects(0) || connects(1));
        next = matters ? (tick + distance() + 1) * prescaler : Avr.NEVER;
        avr.schedule();
    }

    @Override
    public long next() {
        return next;
    }

    @Override
    public void act() {
        sync();
        next = (tick + distance() + 1) * prescaler;
    }

    @Override
    public int read(int address) {
        sync();
        if (address == tifr) {
            return flags;
        }
        int offset = address - base;
        if (offset < 0 || offset > 11) {
            return mask;
        }
        if (offset < 2) {
            return offset == 0 ? tccra : tccrb;
        }
        if (!wide) {
            return offset == 2 ? count : buffer[offset - 3];
        }
        if ((offset & 1) != 0) {
            return offset == 5 ? high : word(offset) >> BITS;
        }
        high = word(offset) >> BITS;
        return word(offset) & BYTE;
    }

    private int word(int offset) {
        int index = offset >> 1;
        return index == 2 ? count : index == 3 ? icr : index < 2 ? 0 : buffer[index - 4];
    }

    @Override
    public void write(int address, int value) {
        sync();
        int offset = address - base;
        if (address == tifr) {
            flags &= ~value;
        } else if (offset < 0 || offset > 11) {
            mask = value;
        } else if (offset == 0) {
            tccra = value;
        } else if (offset == 1) {
            tccrb = value;
            int divisor = (second ? PRESCALERS_2 : PRESCALERS)[value & 7];
            if (divisor != prescaler) {
                prescaler = divisor;
                tick = divisor == 0 ? 0 : avr.cycle / divisor;
            }
        } else if (!wide) {
            set(offset - 1, value);
        } else if ((offset & 1) != 0) {
            high = value;
        } else if (offset > 2) {
            set(offset == 4 ? 1 : offset == 6 ? 0 : (offset >> 1) - 2, value | high << BITS);
        }
        configure();
        raise();
        plan();
    }

    /** @param what 0 for ICR, 1 for TCNT, 2 and 3 for the compare units */
    private void set(int what, int value) {
        if (what == 0) {
            icr = value;
        } else if (what == 1) {
            count = value;
        } else {
            buffer[what - 2] = value;
            if (!buffered()) {
                compare[what - 2] = value;
            }
        }
    }

    @Override
    public void setBit(int address, int bit) {
        write(address, address == tifr ? 1 << bit : read(address) | 1 << bit);
    }
}
