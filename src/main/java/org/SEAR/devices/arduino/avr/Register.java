// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** Registers of a peripheral in the data space. */
interface Register {
    /** @return 0 to 255 */
    int read(int address);

    /** @param value 0 to 255 */
    void write(int address, int value);

    /** Sets one bit as SBI does. Registers whose bits clear or toggle when written 1 write this bit alone. */
    default void setBit(int address, int bit) {
        write(address, read(address) | 1 << bit);
    }
}
