// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Arrays;

/** EEPROM of 1 KiB; a write takes 3.4 ms. Source: data sheet, section 8.4. */
final class Eeprom implements Register, Avr.Peripheral {
    private static final int EECR = 0x3F;
    private static final int EERE = 1;
    private static final int EEPE = 2;
    private static final int EEMPE = 4;
    private static final int EERIE = 8;
    private static final int VECTOR = 22;
    private static final int WRITE_CYCLES = 54400;
    private static final int ARMED_CYCLES = 4;

    private final Avr avr;
    private final byte[] bytes = new byte[1024];
    private int control;
    private int value;
    private int address;
    private long armedUntil;
    private long doneAt;

    Eeprom(Avr avr) {
        this.avr = avr;
        avr.map(this, EECR, EECR + 1, EECR + 2, EECR + 3);
        avr.add(this);
    }

    /** Erases all bytes. */
    void erase() {
        Arrays.fill(bytes, (byte) 0xFF);
    }

    @Override
    public void reset() {
        control = value = address = 0;
        armedUntil = 0;
        doneAt = Avr.NEVER;
    }

    @Override
    public long next() {
        return doneAt;
    }

    @Override
    public void act() {
        doneAt = Avr.NEVER;
        control &= ~EEPE;
        raise();
    }

    private void raise() {
        avr.raise(VECTOR, (control & EERIE) != 0 && (control & EEPE) == 0);
    }

    @Override
    public int read(int register) {
        switch (register - EECR) {
            case 0:
                return avr.cycle > armedUntil ? control & ~EEMPE : control;
            case 1:
                return value;
            case 2:
                return address & 0xFF;
            default:
                return address >> 8;
        }
    }

    @Override
    public void write(int register, int newValue) {
        switch (register - EECR) {
            case 0:
                control(newValue);
                break;
            case 1:
                value = newValue;
                break;
            case 2:
                address = address & 0x300 | newValue;
                break;
            default:
                address = address & 0xFF | (newValue & 3) << 8;
                break;
        }
    }

    private void control(int newValue) {
        boolean busy = (control & EEPE) != 0;
        boolean armed = (control & EEMPE) != 0 && avr.cycle <= armedUntil;
        if ((newValue & EEMPE) != 0 && !armed) {
            armedUntil = avr.cycle + ARMED_CYCLES;
        }
        control = newValue & (0x30 | EERIE | EEMPE) | control & EEPE;
        if ((newValue & EEPE) != 0 && armed && !busy) {
            int mode = newValue >> 4 & 3;
            bytes[address] = (byte) (mode == 1 ? 0xFF : mode == 2 ? bytes[address] & value : value);
            control = control & ~EEMPE | EEPE;
            doneAt = avr.cycle + WRITE_CYCLES;
            avr.cycle += 2;
            avr.schedule();
        } else if ((newValue & EERE) != 0 && !busy) {
            value = bytes[address] & 0xFF;
            avr.cycle += ARMED_CYCLES;
        }
        raise();
    }
}
