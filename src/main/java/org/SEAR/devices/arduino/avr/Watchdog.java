// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** Watchdog timer with an oscillator of 128 kHz. Source: data sheet, section 11.8. */
final class Watchdog implements Register, Avr.Peripheral {
    private static final int WDTCSR = 0x60;
    private static final int MCUSR = 0x54;
    private static final int WDRF = 8;
    private static final int WDIF = 0x80;
    private static final int WDIE = 0x40;
    private static final int WDCE = 0x10;
    private static final int WDE = 0x08;
    private static final int VECTOR = 6;
    /** CPU cycles of the shortest time, 2048 cycles of the oscillator. */
    private static final long SHORTEST = 256000;

    private final Avr avr;
    private int control;
    private int cause;
    private long changeUntil;
    private long expires;

    Watchdog(Avr avr) {
        this.avr = avr;
        avr.map(this, WDTCSR, MCUSR);
        avr.onInterrupt(VECTOR, () -> {
            control &= ~WDIF;
            if ((control & WDE) != 0) {
                control &= ~WDIE;
            }
            avr.raise(VECTOR, false);
        });
        avr.add(this);
    }

    @Override
    public void reset() {
        control = (cause & WDRF) != 0 ? WDE : 0;
        changeUntil = 0;
        restart();
    }

    /** Sets the cause of a reset by power-on or the reset line. */
    void setCause(int flags) {
        cause = flags;
    }

    void restart() {
        int time = control & 7 | control >> 2 & 8;
        expires = (control & (WDE | WDIE)) == 0 ? Avr.NEVER : avr.cycle + (SHORTEST << Math.min(time, 9));
        avr.schedule();
    }

    @Override
    public long next() {
        return expires;
    }

    @Override
    public void act() {
        if ((control & WDIE) != 0) {
            control |= WDIF;
            avr.raise(VECTOR, true);
            restart();
        } else {
            cause |= WDRF;
            avr.restart();
        }
    }

    @Override
    public int read(int address) {
        return address == MCUSR ? cause : control;
    }

    @Override
    public void write(int address, int value) {
        if (address == MCUSR) {
            cause &= value;
            return;
        }
        boolean may = avr.cycle <= changeUntil;
        if ((value & (WDCE | WDE)) == (WDCE | WDE) && !may) {
            changeUntil = avr.cycle + 4;
        }
        int timing = may ? value & 0x27 | value & WDE : control & 0x27 | (control | value) & WDE;
        control = timing | value & WDIE | control & ~value & WDIF;
        if ((cause & WDRF) != 0) {
            control |= WDE;
        }
        avr.raise(VECTOR, (control & WDIF) != 0 && (control & WDIE) != 0);
        restart();
    }
}
