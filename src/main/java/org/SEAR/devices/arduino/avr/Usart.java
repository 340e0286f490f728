// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** USART 0 in asynchronous mode. Source: data sheet, section 20. */
final class Usart implements Register, Avr.Peripheral {
    private static final int BASE = 0xC0;
    private static final int UDR = 0xC6;
    private static final int RXC = 0x80;
    private static final int TXC = 0x40;
    private static final int UDRE = 0x20;
    private static final int DOR = 0x08;
    private static final int U2X = 0x02;
    private static final int RXEN = 0x10;
    private static final int TXEN = 0x08;
    private static final int VECTOR_RX = 18;
    private static final int FIFO = 2;

    private final Avr avr;
    private final int[] fifo = new int[FIFO];
    private int received;
    private int status;
    private int control;
    private int format;
    private int ubrr;
    private int waiting;
    private long sentAt;

    Usart(Avr avr) {
        this.avr = avr;
        avr.map(this, BASE, BASE + 1, BASE + 2, BASE + 4, BASE + 5, UDR);
        avr.onInterrupt(VECTOR_RX + 2, () -> {
            status &= ~TXC;
            raise();
        });
        avr.add(this);
    }

    @Override
    public void reset() {
        status = UDRE;
        control = received = ubrr = 0;
        format = 6;
        waiting = -1;
        sentAt = Avr.NEVER;
    }

    /** Bits per second by UBRR; 0 while neither receiver nor transmitter is on. */
    double baud(double clock) {
        return (control & (RXEN | TXEN)) == 0 ? 0 : clock / cyclesPerBit();
    }

    private int cyclesPerBit() {
        return ((status & U2X) != 0 ? 8 : 16) * (ubrr + 1);
    }

    /** Cycles of a frame: start bit, 5 to 8 data bits, parity, stop bits. */
    private int frame() {
        int bits = 7 + (format >> 1 & 3) + ((format & 0x20) != 0 ? 1 : 0) + ((format & 8) != 0 ? 1 : 0);
        return bits * cyclesPerBit();
    }

    /** A byte has arrived; a third one before the program reads is lost. */
    void receive(int value) {
        if ((control & RXEN) == 0) {
            return;
        }
        if (received < FIFO) {
            fifo[received++] = value;
        } else {
            status |= DOR;
        }
        raise();
    }

    private void start(int value) {
        int cycles = frame();
        sentAt = avr.cycle + cycles;
        avr.surroundings.transmit(0, value, avr.cycle, cycles);
    }

    private void raise() {
        status = received > 0 ? status | RXC : status & ~RXC;
        avr.raise(VECTOR_RX, (status & control & RXC) != 0);
        avr.raise(VECTOR_RX + 1, (status & control & UDRE) != 0);
        avr.raise(VECTOR_RX + 2, (status & control & TXC) != 0);
    }

    @Override
    public long next() {
        return sentAt;
    }

    @Override
    public void act() {
        if (waiting >= 0) {
            start(waiting);
            waiting = -1;
            status |= UDRE;
        } else {
            sentAt = Avr.NEVER;
            status |= TXC;
        }
        raise();
    }

    @Override
    public int read(int address) {
        switch (address - BASE) {
            case 0:
                return status;
            case 1:
                return control;
            case 2:
                return format;
            case 4:
                return ubrr & 0xFF;
            case 5:
                return ubrr >> 8;
            default:
                int value = fifo[0];
                fifo[0] = fifo[1];
                received = Math.max(0, received - 1);
                status &= ~DOR;
                raise();
                return value;
        }
    }

    @Override
    public void write(int address, int value) {
        switch (address - BASE) {
            case 0:
                status = status & ~(U2X | 1) & ~(value & TXC) | value & (U2X | 1);
                break;
            case 1:
                control = value;
                received = (value & RXEN) == 0 ? 0 : received;
                break;
            case 2:
                format = value;
                break;
            case 4:
                ubrr = ubrr & 0xF00 | value;
                break;
            case 5:
                ubrr = ubrr & 0xFF | (value & 0xF) << 8;
                break;
            default:
                send(value);
                break;
        }
        raise();
    }

    private void send(int value) {
        if ((control & TXEN) == 0 || (status & UDRE) == 0) {
            return;
        }
        if (sentAt == Avr.NEVER) {
            start(value);
            avr.schedule();
        } else {
            waiting = value;
            status &= ~UDRE;
        }
    }
}
