// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.arduino;

/** Uses of a pin. */
public enum PinUse {
    /** Reads or writes a level. */
    DIGITAL("a digital pin"),
    /** Reads a voltage with 10 bits. */
    ANALOG("an analog input"),
    /** Makes pulses of any width in hardware. */
    PWM("a PWM pin"),
    /** Makes servo pulses with the Servo library. */
    SERVO("a pin for servos"),
    /** Interrupts the program at a change of level. */
    INTERRUPT("a pin with an interrupt"),
    /** Two-wire bus (I2C). */
    I2C("a pin of the two-wire bus");

    private final String words;

    PinUse(String words) {
        this.words = words;
    }

    /** Name of such a pin, with its article. */
    public String getWords() {
        return words;
    }
}
