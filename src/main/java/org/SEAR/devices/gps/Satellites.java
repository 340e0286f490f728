package org.SEAR.devices.gps;

import java.util.Locale;

/** The satellites that a simulated receiver sees: always these eight. */
final class Satellites {
    /** Number, elevation, azimuth in degrees, signal to noise in dB. */
    private static final int[][] SATELLITES = {{21, 72, 40, 50}, {28, 63, 144, 48}, {8, 52, 251, 46}, {26, 44, 320, 45},
        {15, 37, 88, 44}, {10, 29, 196, 42}, {18, 21, 290, 40}, {3, 16, 12, 38}};
    static final String HDOP = "1.02";
    static final String PDOP = "1.88";
    static final String VDOP = "1.58";
    private static final int CHANNELS_OF_GSA = 12;
    private static final int PER_SENTENCE = 4;
    private static final int CHANNELS = 32;
    private static final int TRACKED = 2;

    private Satellites() {
    }

    static int size() {
        return SATELLITES.length;
    }

    /** {@code GPGSA,A,3,21,28,...,1.88,1.02,1.58}. */
    static String gsa(boolean fix) {
        StringBuilder body = new StringBuilder(fix ? "GPGSA,A,3" : "GPGSA,A,1");
        for (int i = 0; i < CHANNELS_OF_GSA; i++) {
            body.append(',');
            if (fix && i < SATELLITES.length) {
                body.append(two(SATELLITES[i][0]));
            }
        }
        return body.append(fix ? "," + PDOP + "," + HDOP + "," + VDOP : ",,,").toString();
    }

    /** {@code GPGSV,2,1,08,21,72,040,50,...}, four satellites a sentence. */
    static String gsv(int number) {
        StringBuilder body = new StringBuilder("GPGSV," + gsvSentences() + "," + number + "," + two(SATELLITES.length));
        for (int i = (number - 1) * PER_SENTENCE; i < Math.min(number * PER_SENTENCE, SATELLITES.length); i++) {
            int[] s = SATELLITES[i];
            body.append(String.format(Locale.ROOT, ",%02d,%02d,%03d,%02d", s[0], s[1], s[2], s[3]));
        }
        return body.toString();
    }

    static int gsvSentences() {
        return (SATELLITES.length + PER_SENTENCE - 1) / PER_SENTENCE;
    }

    /** {@code PMTKCHN,21502,...}: satellite, signal and state of each of 32 channels. */
    static String channels() {
        StringBuilder body = new StringBuilder("PMTKCHN");
        for (int i = 0; i < CHANNELS; i++) {
            body.append(i < SATELLITES.length ? "," + two(SATELLITES[i][0]) + two(SATELLITES[i][3]) + TRACKED : ",00000");
        }
        return body.toString();
    }

    private static String two(int value) {
        return String.format(Locale.ROOT, "%02d", value);
    }
}
