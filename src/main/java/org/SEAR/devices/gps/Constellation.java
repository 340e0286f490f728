// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Satellites in view of a simulated receiver; always the same. */
enum Constellation {
    GPS("GP", 0, 0, new int[][] {{21, 72, 40, 50}, {28, 63, 144, 48}, {8, 52, 251, 46}, {26, 44, 320, 45},
        {15, 37, 88, 44}, {10, 29, 196, 42}, {18, 21, 290, 40}, {3, 16, 12, 38}}),
    GLONASS("GL", 6, 64, new int[][] {{2, 58, 75, 44}, {9, 47, 210, 43}, {17, 33, 330, 41}, {18, 24, 130, 39}});

    /** Dilutions of precision of both systems together, also used for one system. */
    static final double HDOP = 1.02;
    static final double PDOP = 1.88;
    static final double VDOP = 1.58;
    private static final int PLACES_OF_GSA = 12;
    private static final int PER_SENTENCE = 4;
    private static final int ELEVATION = 1;
    private static final int AZIMUTH = 2;
    private static final int SIGNAL = 3;

    private final String talker;
    private final int ubxId;
    private final int nmeaOffset;
    /** Satellites: number, elevation and azimuth in degrees, signal-to-noise ratio in dB. */
    private final int[][] satellites;

    Constellation(String talker, int ubxId, int nmeaOffset, int[][] satellites) {
        this.talker = talker;
        this.ubxId = ubxId;
        this.nmeaOffset = nmeaOffset;
        this.satellites = satellites;
    }

    int size() {
        return satellites.length;
    }

    /** System identifier in UBX. */
    int getUbxId() {
        return ubxId;
    }

    /** Number of a satellite in its system. */
    int number(int satellite) {
        return satellites[satellite][0];
    }

    /** Elevation of a satellite, degrees. */
    int elevation(int satellite) {
        return satellites[satellite][ELEVATION];
    }

    /** Azimuth of a satellite, degrees. */
    int azimuth(int satellite) {
        return satellites[satellite][AZIMUTH];
    }

    /** Signal-to-noise ratio of a satellite, dB. */
    int signal(int satellite) {
        return satellites[satellite][SIGNAL];
    }

    /** The twelve satellite fields of GSA, {@code ,21,28,...}; all empty without a fix. */
    String used(boolean fix) {
        StringBuilder places = new StringBuilder();
        for (int i = 0; i < PLACES_OF_GSA; i++) {
            places.append(',').append(fix && i < size()
                ? String.format(Locale.ROOT, "%02d", nmeaOffset + number(i)) : "");
        }
        return places.toString();
    }

    /** Bodies of the GSV sentences, {@code GPGSV,2,1,08,21,72,040,50,...}, four satellites per sentence. */
    List<String> gsv(boolean seen) {
        int count = seen ? size() : 0;
        int sentences = Math.max(1, (count + PER_SENTENCE - 1) / PER_SENTENCE);
        List<String> bodies = new ArrayList<>();
        for (int first = 0; first < Math.max(1, count); first += PER_SENTENCE) {
            StringBuilder body = new StringBuilder(
                String.format(Locale.ROOT, "%sGSV,%d,%d,%02d", talker, sentences, bodies.size() + 1, count));
            for (int i = first; i < Math.min(first + PER_SENTENCE, count); i++) {
                body.append(String.format(Locale.ROOT, ",%02d,%02d,%03d,%02d", nmeaOffset + number(i), elevation(i),
                    azimuth(i), signal(i)));
            }
            bodies.add(body.toString());
        }
        return bodies;
    }
}
