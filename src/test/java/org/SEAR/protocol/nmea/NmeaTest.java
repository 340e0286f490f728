// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.nmea;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;

import org.SEAR.Golden;
import org.junit.Test;

/** Frames, numbers and commands as in MediaTek's manual and recordings of real receivers. */
public class NmeaTest {
    private static final Golden NMEA = Golden.of("nmea");
    @Test
    public void sentencesOfRealReceiversHaveThisChecksum() {
        String[] real = NMEA.each("it has restarted", "place without a fix, recorded",
            "place with three satellites, recorded",
            "three satellites in use, recorded", "satellites in view, recorded", "the least that one needs, recorded",
            "course and speed, recorded", "place by an MT3329, recorded");
        for (String sentence : real) {
            String body = Nmea.body(sentence);
            assertEquals(sentence.substring(1, sentence.length() - 3), body);
            assertEquals(sentence + "\r\n", Nmea.sentence(body));
        }
    }

    @Test
    public void aDamagedFrameHasNoBody() {
        String[] damaged = {"", "$", "*00", NMEA.get("a fix each second, its checksum wrong"), "PMTK220,1000*1F",
            "$PMTK220,1000", "$PMTK220,1000*1G", "$PMTK220,1000*1F "};
        for (String line : damaged) {
            assertNull(line, Nmea.body(line));
        }
        assertEquals("lower case is read, too", "PMTK220,1000", Nmea.body("$PMTK220,1000*1f"));
    }

    @Test
    public void commandsAreThoseOfTheManual() {
        assertEquals(NMEA.get("test") + "\r\n", Nmea.sentence(Pmtk.TEST.body()));
        assertEquals(NMEA.get("5 fixes a second") + "\r\n", Nmea.sentence(Pmtk.SET_PERIOD.body(200)));
        assertEquals(NMEA.get("38400 baud") + "\r\n", Nmea.sentence(Pmtk.SET_BAUD.body(38400)));
        assertEquals(NMEA.get("an interval of a second between fixes") + "\r\n",
            Nmea.sentence(Pmtk.SET_FIX_INTERVAL.body(1000, 0, 0, 0, 0)));
        assertEquals(NMEA.get("sentences of its start") + "\r\n", Nmea.sentence(Pmtk.SET_OUTPUT.body(-1)));
        assertEquals(NMEA.get("ask for the release") + "\r\n", Nmea.sentence(Pmtk.QUERY_RELEASE.body()));
        assertEquals(NMEA.get("fixes per second: done") + "\r\n", Nmea.sentence(Pmtk.ACKNOWLEDGE.body(220, 3)));
        assertEquals(NMEA.get("release AXN_1.30") + "\r\n",
            Nmea.sentence(Pmtk.RELEASE.body("AXN_1.30", "0000", "20090609", "")));
        String[] speeds = {"4800*14", "9600*17", "14400*29", "19200*22", "38400*27", "57600*2C", "115200*1F"};
        for (int i = 0; i < speeds.length; i++) {
            assertEquals("$PMTK251," + speeds[i] + "\r\n", Nmea.sentence(Pmtk.SET_BAUD.body(Pmtk.BAUDS.get(i))));
        }
    }

    @Test
    public void commandsAreFoundByTheirField() {
        for (Pmtk command : Pmtk.values()) {
            assertEquals(command, Pmtk.of(Pmtk.numberOf(command.body())));
        }
        assertEquals(999, Pmtk.numberOf("PMTK999"));
        assertNull(Pmtk.of(999));
        for (String none : new String[] {"", "PMTK", "PMTK22", "PMTK2200", "GPGGA", "PMTK-22"}) {
            assertEquals(none, -1, Pmtk.numberOf(none));
        }
    }

    @Test
    public void coordinatesAreReadAsTheyAreWritten() {
        assertEquals("3336.600000", Nmea.degrees(33.61, Nmea.LATITUDE_DIGITS, 6));
        assertEquals("08051.9000", Nmea.degrees(-80.865, Nmea.LONGITUDE_DIGITS, 4));
        assertEquals("minutes never show as 60", "0800.0000", Nmea.degrees(7.99999999, Nmea.LATITUDE_DIGITS, 4));
        assertEquals(52.21636892, Nmea.degrees("5212.982135"), 1e-8);
        assertEquals(80.864998, Nmea.degrees("08051.8999"), 1e-6);
        assertEquals("fewer digits of the degrees", 8.5, Nmea.degrees("830.0"), 1e-9);
        assertEquals("on the equator", 0.5, Nmea.degrees("30.0"), 1e-9);
    }

    @Test
    public void otherTextIsNoCoordinate() {
        for (String field : new String[] {"", ".", "3336", "-3336.6", "123456.7", "33N36.6"}) {
            assertEquals("\"" + field + "\" is no coordinate, legal: ddmm.mmmm or dddmm.mmmm",
                assertThrows(field, IllegalArgumentException.class, () -> Nmea.degrees(field)).getMessage());
        }
    }

    @Test
    public void numbersHaveAPointAndNoNegativeZero() {
        assertEquals("-0.5", Nmea.number(-0.5, 1));
        assertEquals("0.0", Nmea.number(-0.01, 1));
        assertEquals("1234.50", Nmea.number(1234.5, 2));
    }
}
