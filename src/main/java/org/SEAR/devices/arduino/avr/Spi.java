// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** SPI as a master without devices: every byte takes its time, and the received one is 0xFF. Data sheet, section 19. */
final class Spi implements Register, Avr.Peripheral {
    private static final int SPCR = 0x4C;
    private static final int SPSR = 0x4D;
    private static final int SPDR = 0x4E;
    private static final int SPIF = 0x80;
    private static final int SPIE = 0x80;
    private static final int SPE = 0x40;
    private static final int MSTR = 0x10;
    private static final int SPI2X = 0x01;
    private static final int VECTOR = 17;
    private static final int[] DIVISORS = {4, 16, 64, 128};
    private static final int BITS = 8;
    private static final int OPEN = 0xFF;

    private final Avr avr;
    private int control;
    private int status;
    private int value;
    private boolean statusRead;
    private long doneAt;

    Spi(Avr avr) {
        this.avr = avr;
        avr.map(this, SPCR, SPSR, SPDR);
        avr.onInterrupt(VECTOR, this::clear);
        avr.add(this);
    }

    @Override
    public void reset() {
        control = status = value = 0;
        statusRead = false;
        doneAt = Avr.NEVER;
    }

    private void clear() {
        status &= ~SPIF;
        statusRead = false;
        raise();
    }

    private void raise() {
        avr.raise(VECTOR, (status & SPIF) != 0 && (control & SPIE) != 0);
    }

    @Override
    public long next() {
        return doneAt;
    }

    @Override
    public void act() {
        doneAt = Avr.NEVER;
        value = OPEN;
        status |= SPIF;
        raise();
    }

    /** The flag is cleared by an access to the data after reading the status. */
    private void accessData() {
        if (statusRead) {
            clear();
        }
    }

    @Override
    public int read(int address) {
        if (address == SPCR) {
            return control;
        }
        if (address == SPSR) {
            statusRead = (status & SPIF) != 0;
            return status;
        }
        accessData();
        return value;
    }

    @Override
    public void write(int address, int newValue) {
        if (address == SPCR) {
            control = newValue;
            raise();
        } else if (address == SPSR) {
            status = status & SPIF | newValue & SPI2X;
        } else {
            accessData();
            if ((control & (SPE | MSTR)) == (SPE | MSTR) && doneAt == Avr.NEVER) {
                doneAt = avr.cycle + (long) BITS * DIVISORS[control & 3] / ((status & SPI2X) != 0 ? 2 : 1);
                avr.schedule();
            }
        }
    }
}
