package org.SEAR.protocol.arduino;

/** What the wire between a pin and a component is for. */
public enum WireRole {
    /** The component puts a voltage on the pin. */
    VOLTS("volts", PinUse.ANALOG),
    /** One pin for the trigger and the echo of a range sensor, as a PING))) has it. */
    PING("ping", PinUse.DIGITAL),
    /** The pin starts a range sensor, as an HC-SR04's. */
    TRIGGER("trigger", PinUse.DIGITAL),
    /** The pin is high as long as the sound travels, as an HC-SR04's. */
    ECHO("echo", PinUse.DIGITAL),
    /** Power of a motor; forward, if it has another for reverse. */
    PWM("pwm", PinUse.PWM),
    /** Power of a motor in reverse. */
    REVERSE("reverse", PinUse.PWM),
    /** Direction of a motor: high forward. */
    DIRECTION("direction", PinUse.DIGITAL),
    /** First track of a motor's encoder. */
    ENCODER_A("encoderA", PinUse.INTERRUPT),
    /** Second track of a motor's encoder, a quarter of a line behind the first when it turns forward. */
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

    /** The role of a word as {@link #getWord} has it, in whatever capitals; null if there is none. */
    public static WireRole of(String word) {
        for (WireRole role : values()) {
            if (role.word.equalsIgnoreCase(word)) {
                return role;
            }
        }
        return null;
    }

    /** As scripts and files say it. */
    public String getWord() {
        return word;
    }

    /** What the pin must be able to do. */
    public PinUse getUse() {
        return use;
    }
}
