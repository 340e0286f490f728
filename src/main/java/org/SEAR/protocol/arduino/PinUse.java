package org.SEAR.protocol.arduino;

/** What a pin can be used for. */
public enum PinUse {
    /** A level is read or written. */
    DIGITAL("a digital pin"),
    /** A voltage is read with 10 bits. */
    ANALOG("an analog input"),
    /** The hardware makes pulses of any width. */
    PWM("a PWM pin"),
    /** The servo library makes its pulses. */
    SERVO("a pin for servos"),
    /** A change of level interrupts the program. */
    INTERRUPT("a pin with an interrupt"),
    /** Two-wire bus. */
    I2C("a pin of the two-wire bus");

    private final String words;

    PinUse(String words) {
        this.words = words;
    }

    /** What such a pin is called, with its article. */
    public String getWords() {
        return words;
    }
}
