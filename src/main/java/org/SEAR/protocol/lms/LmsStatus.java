// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/**
 * The status telegram B1h with 154 bytes of payload (SICK telegram listing, table 7-33). Pollution, calibration, motor
 * and peak voltages, and counters are not simulated. They have the values of a clean real device, from a recorded
 * telegram. Immutable.
 */
public final class LmsStatus {
    /** Size of command, data and status byte, bytes. */
    public static final int SIZE = 154;
    private static final int MODE_AT = 8;
    private static final int SPREAD_AT = 107;
    private static final int RESOLUTION_AT = 109;
    private static final int BAUD_AT = 116;
    private static final int UNIT_AT = 122;
    private static final int[] POLLUTION = {402, 0, 282, 0, 479, 0, 667, 0};
    private static final int[] REFERENCE_POLLUTION = {375, 273, 449, 326};
    private static final int[] POLLUTION_CALIBRATION = {432, 594, 359, 494, 472, 472, 660, 907};
    private static final int[] REFERENCE_CALIBRATION = {357, 357, 434, 434};
    private static final int MOTOR = 148;
    /** Offsets 69 to 101: dark references, amplitude, angle, peak thresholds, targets. */
    private static final int[] SIGNALS = {1, 1, 2, 0, 1, 0, 0, 0xA1, 0x125, 0xB0C, 0x126, 0xA80, 0x399, 0x399,
        0x399, 0x399};
    private static final int SIGNAL_END = 0x08;
    private static final int[] REFERENCE_TARGETS = {0x300, 0x200};
    private static final int RESTART_MODE = 2;
    private static final int EVALUATIONS = 2;
    private static final String BOOT_VERSION = "V02.02 ";
    private static final int[] CALIBRATION = {0x079E0B, 0x1EC4E3, 0x07A354, 0x1ECC35};
    private static final int[] COUNTERS = {0x652, 0x68E, 600};

    private final Telegram telegram;

    private LmsStatus(Telegram telegram) {
        this.telegram = telegram;
    }

    /**
     * Reads a telegram.
     *
     * @throws IllegalArgumentException if it is too short
     */
    public static LmsStatus of(Telegram telegram) {
        if (telegram.size() < SIZE) {
            throw new IllegalArgumentException("status has only " + telegram.size() + " bytes");
        }
        return new LmsStatus(telegram);
    }

    /**
     * Encodes the payload of the telegram.
     *
     * @param mode see {@link OperatingMode}
     * @param permanent whether the baud rate survives a reset
     * @param status last byte, see {@link StatusByte}
     */
    public static byte[] encode(Identity identity, int mode, Variant variant, Configuration configuration, Baud baud,
        boolean permanent, int status) {
        LmsPayload p = LmsCommand.STATUS.reply().text(identity.getVersion()).add(mode).add(0)
            .text(identity.getSerial()).add(0);
        p.words(POLLUTION).words(REFERENCE_POLLUTION).words(POLLUTION_CALIBRATION).words(REFERENCE_CALIBRATION);
        p.word(MOTOR).words(SIGNALS).add(SIGNAL_END).add(configuration.getMode().getCode()).words(REFERENCE_TARGETS);
        p.word(variant.getSpread()).word(variant.getResolution()).add(RESTART_MODE).word(0).add(0).add(1);
        p.word(baud.getStatusWord()).add(EVALUATIONS).add(permanent ? 1 : 0).add(identity.getAddress()).add(1);
        p.add(configuration.getUnit()).add(1).text(BOOT_VERSION);
        for (int value : CALIBRATION) {
            p.doubleWord(value);
        }
        return p.words(COUNTERS).add(status).toBytes();
    }

    /** Operating mode, see {@link OperatingMode}. */
    public int getMode() {
        return telegram.at(MODE_AT);
    }

    /** Angle from the first to the last value, degrees. */
    public int getSpread() {
        return telegram.wordAt(SPREAD_AT);
    }

    /** Angle between two values, 1/100 degree. */
    public int getResolution() {
        return telegram.wordAt(RESOLUTION_AT);
    }

    /** Baud rate, see {@link Baud#getStatusWord}. */
    public int getBaudWord() {
        return telegram.wordAt(BAUD_AT);
    }

    /** 0 = centimetres, 1 = millimetres. */
    public int getUnit() {
        return telegram.at(UNIT_AT);
    }
}
