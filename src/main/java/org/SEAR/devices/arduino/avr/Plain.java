// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** Registers that keep what the program writes, without any other effect. */
final class Plain implements Register {
    private final Avr avr;

    Plain(Avr avr) {
        this.avr = avr;
    }

    @Override
    public int read(int address) {
        return avr.data[address] & 0xFF;
    }

    @Override
    public void write(int address, int value) {
        avr.data[address] = (byte) value;
    }
}
