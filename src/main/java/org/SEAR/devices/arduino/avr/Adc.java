// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** Analog to digital converter, 10 bits, 5 V supply. Source: data sheet, section 24. */
final class Adc implements Register, Avr.Peripheral {
    private static final int ADCL = 0x78;
    private static final int ADCSRA = 0x7A;
    private static final int ADEN = 0x80;
    private static final int ADSC = 0x40;
    private static final int ADATE = 0x20;
    private static final int ADIF = 0x10;
    private static final int ADIE = 0x08;
    private static final int VECTOR = 21;
    private static final int CLOCKS = 13;
    private static final int FIRST_CLOCKS = 25;
    private static final double SUPPLY = 5;
    private static final double BANDGAP = 1.1;
    private static final int STEPS = 1024;

    private final Avr avr;
    private int control;
    private int trigger;
    private int admux;
    private int result;
    private int sample;
    private boolean first;
    private long doneAt;

    Adc(Avr avr) {
        this.avr = avr;
        avr.map(this, ADCL, ADCL + 1, ADCSRA, ADCL + 3, ADCL + 4);
        avr.onInterrupt(VECTOR, () -> {
            control &= ~ADIF;
            raise();
        });
        avr.add(this);
    }

    @Override
    public void reset() {
        control = trigger = admux = result = 0;
        first = true;
        doneAt = Avr.NEVER;
    }

    private void raise() {
        avr.raise(VECTOR, (control & ADIF) != 0 && (control & ADIE) != 0);
    }

    private void start() {
        int divisor = 1 << Math.max(1, control & 7);
        doneAt = avr.cycle + (long) divisor * (first ? FIRST_CLOCKS : CLOCKS);
        first = false;
        int channel = admux & 15;
        double volts = channel < 8 ? avr.surroundings.volts(channel, avr.cycle) : channel == 14 ? BANDGAP : 0;
        double reference = admux >> 6 == 3 ? BANDGAP : SUPPLY;
        sample = (int) Math.max(0, Math.min(STEPS - 1, Math.floor(volts * STEPS / reference)));
    }

    @Override
    public long next() {
        return doneAt;
    }

    @Override
    public void act() {
        result = (admux & 0x20) != 0 ? sample << 6 : sample;
        control |= ADIF;
        doneAt = Avr.NEVER;
        if ((control & ADATE) != 0 && (trigger & 7) == 0) {
            start();
        } else {
            control &= ~ADSC;
        }
        raise();
    }

    @Override
    public int read(int address) {
        switch (address - ADCL) {
            case 0:
                return result & 0xFF;
            case 1:
                return result >> 8;
            case 2:
                return control;
            case 3:
                return trigger;
            default:
                return admux;
        }
    }

    @Override
    public void write(int address, int value) {
        if (address == ADCSRA) {
            int flag = control & ~value & ADIF;
            boolean runs = doneAt != Avr.NEVER && (value & ADEN) != 0;
            control = value & ~(ADIF | ADSC) | flag | (runs ? ADSC : 0);
            if ((value & ADEN) == 0) {
                doneAt = Avr.NEVER;
                first = true;
            } else if (!runs && (value & ADSC) != 0) {
                control |= ADSC;
                start();
            }
            raise();
            avr.schedule();
        } else if (address == ADCL + 3) {
            trigger = value;
            if ((value & 7) != 0) {
                avr.report("ADC trigger sources other than free running are not simulated");
            }
        } else if (address == ADCL + 4) {
            admux = value;
        }
    }
}
