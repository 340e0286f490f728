// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/**
 * Two-wire interface (I2C) as a master on a bus without devices: start and stop work, no address is acknowledged.
 * Source: data sheet, section 22, with its status codes.
 */
final class Twi implements Register, Avr.Peripheral {
    private static final int TWBR = 0xB8;
    private static final int TWSR = 0xB9;
    private static final int TWDR = 0xBB;
    private static final int TWCR = 0xBC;
    private static final int TWINT = 0x80;
    private static final int TWSTA = 0x20;
    private static final int TWSTO = 0x10;
    private static final int TWEN = 0x04;
    private static final int TWIE = 0x01;
    private static final int PRESCALER = 3;
    private static final int VECTOR = 24;
    private static final int NO_STATE = 0xF8;
    private static final int START = 0x08;
    private static final int REPEATED_START = 0x10;
    private static final int WRITE_NOT_ACKNOWLEDGED = 0x20;
    private static final int DATA_NOT_ACKNOWLEDGED = 0x30;
    private static final int READ_NOT_ACKNOWLEDGED = 0x48;
    private static final int RECEIVED_LAST = 0x58;
    private static final int IDLE = 0xFF;
    /** SCL periods of a byte with its acknowledge bit. */
    private static final int BITS = 9;

    private final Avr avr;
    private int rate;
    private int prescaler;
    private int status;
    private int next;
    private int value;
    private int control;
    private boolean held;
    private long doneAt;

    Twi(Avr avr) {
        this.avr = avr;
        avr.map(this, TWBR, TWSR, TWDR, TWCR);
        avr.add(this);
    }

    @Override
    public void reset() {
        rate = prescaler = control = 0;
        value = IDLE;
        release();
    }

    private void release() {
        held = false;
        status = NO_STATE;
        doneAt = Avr.NEVER;
    }

    private void raise() {
        avr.raise(VECTOR, (control & TWINT) != 0 && (control & TWIE) != 0);
    }

    @Override
    public long next() {
        return doneAt;
    }

    @Override
    public void act() {
        doneAt = Avr.NEVER;
        held = true;
        status = next;
        if (status == RECEIVED_LAST) {
            value = IDLE;
        }
        control |= TWINT;
        raise();
    }

    private void begin() {
        if ((control & TWSTO) != 0) {
            control &= ~TWSTO;
            release();
        }
        if ((control & TWSTA) != 0) {
            start(held ? REPEATED_START : START, 1);
        } else if (held) {
            start(answer(), BITS);
        }
    }

    private int answer() {
        switch (status) {
            case START:
            case REPEATED_START:
                return (value & 1) == 0 ? WRITE_NOT_ACKNOWLEDGED : READ_NOT_ACKNOWLEDGED;
            case WRITE_NOT_ACKNOWLEDGED:
            case DATA_NOT_ACKNOWLEDGED:
                return DATA_NOT_ACKNOWLEDGED;
            default:
                return RECEIVED_LAST;
        }
    }

    private void start(int newStatus, int periods) {
        next = newStatus;
        doneAt = avr.cycle + periods * (16L + (2L * rate << 2 * prescaler));
    }

    @Override
    public int read(int address) {
        switch (address) {
            case TWBR:
                return rate;
            case TWSR:
                return status | prescaler;
            case TWDR:
                return value;
            default:
                return control;
        }
    }

    @Override
    public void write(int address, int newValue) {
        if (address == TWBR) {
            rate = newValue;
        } else if (address == TWSR) {
            prescaler = newValue & PRESCALER;
        } else if (address == TWDR) {
            value = newValue;
        } else {
            boolean clears = (newValue & TWINT) != 0;
            control = newValue & ~TWINT | (clears ? 0 : control & TWINT);
            if ((newValue & TWEN) == 0) {
                control &= ~TWINT;
                release();
            } else if (clears) {
                begin();
            }
            raise();
            avr.schedule();
        }
    }
}
