// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import org.SEAR.protocol.cola.ColaError;
import org.SEAR.protocol.cola.ColaException;
import org.SEAR.protocol.cola.ColaPayload;
import org.SEAR.protocol.cola.ColaTelegram;

/** Settings of a scanner that mEEwriteall saves: rate, angles, name, and contents of a scan telegram. Immutable. */
final class ScannerSettings {
    private static final double SLACK = 1e-6;
    private static final int BOTH_ECHOES = 3;
    private static final int CHANNELS = 0;
    private static final int REMISSION = 2;
    private static final int REMISSION_16_BIT = 3;
    private static final int FIRST_FLAG = 7;
    private static final int NAME = 8;
    private static final int TIME = 10;
    private static final int EVERY = 11;
    private static final int[] AS_DELIVERED = {1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1};

    final ColaModel.ScanRate rate;
    /** First and last angle, 1/10000 degree; 90 degrees is straight ahead. */
    final int start;
    final int stop;
    /** Location name. */
    final String name;
    /** The values of LMDscandatacfg. */
    private final int[] content;

    private ScannerSettings(ColaModel.ScanRate rate, int start, int stop, String name, int[] content) {
        this.rate = rate;
        this.start = start;
        this.stop = stop;
        this.name = name;
        this.content = content;
    }

    /**
     * Creates the factory settings.
     *
     * @param spread range of angles, degrees
     */
    static ScannerSettings of(ColaModel.ScanRate rate, double spread) {
        int half = (int) Math.round(spread / 2 * ColaModel.TEN_THOUSANDTHS);
        return new ScannerSettings(rate, ColaModel.FORWARD - half, ColaModel.FORWARD + half, "not defined",
            AS_DELIVERED);
    }

    ScannerSettings withRate(ColaModel.ScanRate newRate) {
        return new ScannerSettings(newRate, start, stop, name, content);
    }

    ScannerSettings withName(String newName) {
        return new ScannerSettings(rate, start, stop, newName, content);
    }

    /**
     * Changes the angles, 1/10000 degree.
     *
     * @throws ColaException if they exceed the model's range
     */
    ScannerSettings withAngles(ColaModel model, int first, int last) throws ColaException {
        if (first < model.firstAngle || last > model.lastAngle || first > last) {
            throw new ColaException(ColaError.INVALID_DATA);
        }
        return new ScannerSettings(rate, first, last, name, content);
    }

    /**
     * Reads the values of LMDscandatacfg: {@code 01 00 0 1 0 00 00 0 0 0 0 +1}.
     *
     * @throws ColaException if one is missing or illegal
     */
    ScannerSettings withContent(ColaTelegram in) throws ColaException {
        int[] read = new int[AS_DELIVERED.length];
        for (int i = 0; i < read.length; i++) {
            read[i] = i == EVERY ? in.u2() : in.u1();
            boolean flag = i == REMISSION || i == REMISSION_16_BIT || i >= FIRST_FLAG && i < EVERY;
            if (flag && read[i] > 1) {
                throw new ColaException(ColaError.INVALID_DATA);
            }
        }
        if (read[CHANNELS] == 0 || read[CHANNELS] > BOTH_ECHOES || read[EVERY] == 0) {
            throw new ColaException(ColaError.INVALID_DATA);
        }
        return new ScannerSettings(rate, start, stop, name, read);
    }

    /** Writes the values of LMDscandatacfg. */
    void writeContent(ColaPayload out) {
        for (int i = 0; i < EVERY; i++) {
            out.u1(content[i]);
        }
        out.u2(content[EVERY]);
    }

    /** Angle from the forward axis to the first measurement, degrees, + to the left. */
    double firstAngle() {
        return (start - ColaModel.FORWARD) / ColaModel.TEN_THOUSANDTHS;
    }

    /** Number of measurements. */
    int beams() {
        return (int) Math.floor((stop - start) / ColaModel.TEN_THOUSANDTHS / rate.degrees() + SLACK) + 1;
    }

    /**
     * Whether the distances of an echo are sent.
     *
     * @param echo 1 or 2
     */
    boolean hasEcho(int echo) {
        return (content[CHANNELS] & echo) != 0;
    }

    /** Whether remissions are sent. */
    boolean hasRemission() {
        return content[REMISSION] == 1;
    }

    /** Whether remissions are words; else bytes. */
    boolean isRemissionWide() {
        return content[REMISSION_16_BIT] == 1;
    }

    /** Whether the name is sent. */
    boolean hasName() {
        return content[NAME] == 1;
    }

    /** Whether the date is sent. */
    boolean hasTime() {
        return content[TIME] == 1;
    }

    /** Interval of transmitted scans: every n-th. */
    int every() {
        return content[EVERY];
    }
}
