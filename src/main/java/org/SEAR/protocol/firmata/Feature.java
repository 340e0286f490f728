// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.firmata;

/** Identifiers of sysex messages. */
public final class Feature {
    /** Encoders, see {@link EncoderMessage}. */
    public static final int ENCODER = 0x61;
    /** Analog channel of each pin. */
    public static final int ANALOG_MAPPING_QUERY = 0x69;
    public static final int ANALOG_MAPPING_RESPONSE = 0x6A;
    /** Modes of each pin. */
    public static final int CAPABILITY_QUERY = 0x6B;
    public static final int CAPABILITY_RESPONSE = 0x6C;
    /** Mode and value of a pin. */
    public static final int PIN_STATE_QUERY = 0x6D;
    public static final int PIN_STATE_RESPONSE = 0x6E;
    /** Analog write to any pin, with any number of bits. */
    public static final int EXTENDED_ANALOG = 0x6F;
    /** Range of a servo's pulses. */
    public static final int SERVO_CONFIG = 0x70;
    /** Text message. */
    public static final int STRING = 0x71;
    /** Echo of a range sensor, see {@link EchoMessage}. */
    public static final int ECHO = 0x75;
    public static final int I2C_REQUEST = 0x76;
    public static final int I2C_REPLY = 0x77;
    public static final int I2C_CONFIG = 0x78;
    /** Name and version of the firmware. */
    public static final int FIRMWARE = 0x79;
    /** Sampling interval of the analog channels, ms. */
    public static final int SAMPLING_INTERVAL = 0x7A;

    private Feature() {
    }
}
