// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.time.format.DateTimeFormatter;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/** Differences between makers' NMEA sentences, as data. Source: recordings of real receivers. */
enum SentenceStyle {
    MT3301("GP", "HHmmss.SSS", 6, 3, "%d", true, "8960.000000,N,00000.000000,E", "137.000,M,13.000,M", "",
        ",T,,M,,N,,K", Constellation.GPS),
    MT3329("GP", "HHmmss.SSS", 4, 1, "%d", true, ",,,", ",M,,M", "", ",T,,M,,N,,K", Constellation.GPS),
    UBLOX("GN", "HHmmss.SS", 5, 1, "%02d", false, ",,,", ",,,", "99.99", ",,,,,,,", Constellation.GPS,
        Constellation.GLONASS);

    /** Talker of sentences that concern all constellations. */
    final String talker;
    final DateTimeFormatter time;
    final int minuteDecimals;
    /** Decimals of altitude and geoid separation, metres. */
    final int altitudeDecimals;
    final String satelliteFormat;
    /** Whether a standing receiver reports the course 0. */
    final boolean courseWhileStanding;
    /** Fields 2 to 5 of GGA without a fix. */
    final String noPosition;
    /** Fields 9 to 12 of GGA without a fix. */
    final String noAltitude;
    /** Dilution of precision without a fix. */
    final String noDop;
    /** Fields 1 to 8 of VTG without a fix. */
    final String noCourse;
    /** Constellations whose satellites it sees. */
    final List<Constellation> sky;

    SentenceStyle(String talker, String time, int minuteDecimals, int altitudeDecimals, String satelliteFormat,
        boolean courseWhileStanding,
            String noPosition, String noAltitude, String noDop, String noCourse, Constellation... sky) {
        this.talker = talker;
        this.time = DateTimeFormatter.ofPattern(time, Locale.ROOT);
        this.minuteDecimals = minuteDecimals;
        this.altitudeDecimals = altitudeDecimals;
        this.satelliteFormat = satelliteFormat;
        this.courseWhileStanding = courseWhileStanding;
        this.noPosition = noPosition;
        this.noAltitude = noAltitude;
        this.noDop = noDop;
        this.noCourse = noCourse;
        this.sky = Collections.unmodifiableList(Arrays.asList(sky));
    }

    /** Number of satellites used for a fix. */
    int satellites() {
        return sky.stream().mapToInt(Constellation::size).sum();
    }
}
