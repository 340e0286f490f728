// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.arduino;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** An Arduino board: its pins and their functions. Immutable. */
public enum BoardModel {
    /** ATmega328P. */
    UNO("Uno", 2, 14, 6, new int[] {3, 5, 6, 9, 10, 11}, new int[] {2, 3}, new int[] {18, 19}, 20),
    /** ATmega2560. */
    MEGA("Mega", 1, 54, 16, new int[] {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 44, 45, 46},
        new int[] {2, 3, 18, 19, 20, 21}, new int[] {20, 21}, 50);

    /** Supply voltage and high level, V. */
    public static final double VOLTS = 5;
    private static final int UNO_FLASH = 0x8000;
    /** First free pin; the pins below belong to the serial line. */
    private static final int FIRST_FREE = 2;

    private final String title;
    private final int mrlType;
    private final int firstAnalog;
    private final int analogs;
    private final int[] pwm;
    private final int[] interrupts;
    private final int[] twoWire;
    private final int servoEnd;

    BoardModel(String title, int mrlType, int firstAnalog, int analogs, int[] pwm, int[] interrupts, int[] twoWire,
        int servoEnd) {
        this.title = title;
        this.mrlType = mrlType;
        this.firstAnalog = firstAnalog;
        this.analogs = analogs;
        this.pwm = pwm;
        this.interrupts = interrupts;
        this.twoWire = twoWire;
        this.servoEnd = servoEnd;
    }

    /** Finds a board by name, {@code uno} or {@code mega}, ignoring case; null if unknown. */
    public static BoardModel of(String name) {
        for (BoardModel model : values()) {
            if (model.title.equalsIgnoreCase(name)) {
                return model;
            }
        }
        return null;
    }

    /** Title, for example {@code Uno}. */
    public String getTitle() {
        return title;
    }

    /** Name in scripts and files, for example {@code uno}. */
    public String getWord() {
        return title.toLowerCase(Locale.ROOT);
    }

    /** MyRobotLab's number of this kind of board. */
    public int getMrlType() {
        return mrlType;
    }

    /** Flash of its microcontroller for a compiled sketch, bytes; 0 if SEAR does not simulate its microcontroller. */
    public int getFlash() {
        return this == UNO ? UNO_FLASH : 0;
    }

    /** Number of pins; the first is 0. */
    public int getPins() {
        return firstAnalog + analogs;
    }

    /** Pin of analog channel 0. */
    public int getFirstAnalog() {
        return firstAnalog;
    }

    /** Number of analog channels. */
    public int getAnalogs() {
        return analogs;
    }

    /** Analog channel of a pin; -1 if it has none. */
    public int channelOf(int pin) {
        return pin >= firstAnalog && pin < getPins() ? pin - firstAnalog : -1;
    }

    /** Whether a pin exists and supports a use. Pins 0 and 1 support none, as they belong to the serial line. */
    public boolean can(int pin, PinUse use) {
        if (pin < FIRST_FREE || pin >= getPins()) {
            return false;
        }
        switch (use) {
            case ANALOG:
                return pin >= firstAnalog;
            case PWM:
                return contains(pwm, pin);
            case SERVO:
                return pin < servoEnd;
            case INTERRUPT:
                return contains(interrupts, pin);
            case I2C:
                return contains(twoWire, pin);
            default:
                return true;
        }
    }

    private static boolean contains(int[] pins, int pin) {
        return IntStream.of(pins).anyMatch(each -> each == pin);
    }

    /**
     * Parses the usual name of a pin: {@code 7}, {@code D7}, {@code A0}.
     *
     * @return -1 if there is no such pin
     */
    public int pinOf(String name) {
        String plain = name == null ? "" : name.trim().toUpperCase(Locale.ROOT);
        boolean analog = plain.startsWith("A");
        String digits = analog || plain.startsWith("D") ? plain.substring(1) : plain;
        if (!digits.matches("[0-9]{1,3}")) {
            return -1;
        }
        int number = Integer.parseInt(digits);
        if (analog) {
            return number < analogs ? firstAnalog + number : -1;
        }
        return number < getPins() ? number : -1;
    }

    /** Label of a pin: {@code 7}, {@code A0}. */
    public String nameOf(int pin) {
        return pin >= firstAnalog ? "A" + (pin - firstAnalog) : Integer.toString(pin);
    }

    /** Lists the pins that support a use, separated by commas; runs of more than two as {@code 2 to 13}. */
    public String pinsFor(PinUse use) {
        return pinsFor(use, pin -> true);
    }

    /** Lists the pins that support a use and pass a test; {@code none} if there are none. */
    public String pinsFor(PinUse use, IntPredicate test) {
        int[] pins = IntStream.range(0, getPins()).filter(pin -> can(pin, use) && test.test(pin)).toArray();
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < pins.length;) {
            int end = i;
            while (end + 1 < pins.length && pins[end + 1] == pins[end] + 1
                && channelOf(pins[end + 1]) >= 0 == channelOf(pins[i]) >= 0) {
                end++;
            }
            text.append(text.length() == 0 ? "" : ", ");
            text.append(end > i + 1 ? nameOf(pins[i]) + " to " + nameOf(pins[end])
                : IntStream.rangeClosed(i, end).mapToObj(each -> nameOf(pins[each])).collect(Collectors.joining(", ")));
            i = end + 1;
        }
        return text.length() == 0 ? "none" : text.toString();
    }

    /** Names of all boards, separated by commas. */
    public static String words() {
        return Arrays.stream(values()).map(BoardModel::getWord).collect(Collectors.joining(", "));
    }
}
