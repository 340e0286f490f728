// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.arduino;

/** Purpose of the wire between a pin and a component. */
public enum WireRole {
    /** Voltage from the component to the pin. */
    VOLTS("volts", PinUse.ANALOG),
    /** Trigger and echo of a range sensor on one pin, as for a PING))). */
    PING("ping", PinUse.DIGITAL),
    /** Trigger of a range sensor, as for an HC-SR04. */
    TRIGGER("trigger", PinUse.DIGITAL),
    /** Echo of a range sensor, high while the sound travels, as for an HC-SR04. */
    ECHO("echo", PinUse.DIGITAL),
    /** Power of a motor; forward only, if the motor also has {@link #REVERSE}. */
    PWM("pwm", PinUse.PWM),
    /** Power of a motor in reverse. */
    REVERSE("reverse", PinUse.PWM),
    /** Direction of a motor: high forward. */
    DIRECTION("direction", PinUse.DIGITAL),
    /** First track of a motor's encoder. */
    ENCODER_A("encoderA", PinUse.INTERRUPT),
    /** Second track of a motor's encoder, a quarter line behind the first when turning forward. */
    ENCODER_B("encoderB", PinUse.DIGITAL),
    /** Pulses for a servo. */
    SERVO("servo", PinUse.SERVO),
    /** A switch between the pin and ground. */
    SWITCH("switch", PinUse.DIGITAL),
    /** A light, lit by a high pin. */
    LIGHT("light", PinUse.DIGITAL);

    private final String word;
    private final PinUse use;

    WireRole(String word, PinUse use) {
        this.word = word;
        this.use = use;
    }

    /** Finds a role by its word, ignoring case; null if unknown. */
    public static WireRole of(String word) {
        for (WireRole role : values()) {
            if (role.word.equalsIgnoreCase(word)) {
                return role;
            }
        }
        return null;
    }

    /** Word in scripts and files. */
    public String getWord() {
        return word;
    }

    /** Required use of the pin. */
    public PinUse getUse() {
        return use;
    }
}
