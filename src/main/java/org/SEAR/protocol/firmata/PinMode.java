// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.firmata;

/** Pin modes with their code and their resolution in bits, as in the capability response. */
public enum PinMode {
    /** Digital input. */
    INPUT(0x00, 1),
    /** Digital input with its pull-up resistor. */
    PULLUP(0x0B, 1),
    /** Digital output. */
    OUTPUT(0x01, 1),
    /** Analog input. */
    ANALOG(0x02, 10),
    /** Pulse width modulation. */
    PWM(0x03, 8),
    /** Servo pulses. */
    SERVO(0x04, 14),
    /** Two-wire bus. */
    I2C(0x06, 1);

    private final int code;
    private final int resolution;

    PinMode(int code, int resolution) {
        this.code = code;
        this.resolution = resolution;
    }

    /** Finds a mode by code; null if unknown. */
    public static PinMode of(int code) {
        for (PinMode mode : values()) {
            if (mode.code == code) {
                return mode;
            }
        }
        return null;
    }

    /** Code in messages. */
    public int getCode() {
        return code;
    }

    /** Resolution, bits. */
    public int getResolution() {
        return resolution;
    }
}
