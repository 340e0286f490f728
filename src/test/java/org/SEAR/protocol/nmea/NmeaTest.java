package org.SEAR.protocol.nmea;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import org.junit.Test;

/** Frames, numbers and commands as in MediaTek's manual and recordings of real receivers. */
public class NmeaTest {
    @Test
    public void sentencesOfRealReceiversHaveThisChecksum() {
        String[] real = {"$PMTK010,001*2E", "$GPGGA,235946.005,8960.000000,N,00000.000000,E,0,0,,137.000,M,13.000,M,,*49",
            "$GPGGA,081436.000,5212.982135,N,00653.101394,E,1,3,2.88,102.907,M,47.093,M,,*5F", "$GPGSA,A,2,21,28,08,,,,,,,,,,3.05,2.88,1.00*07",
            "$GPGSV,3,1,11,08,63,065,50,28,42,144,52,21,13,320,42,26,,,48*44",
            "$GPRMC,081436.000,A,5212.982135,N,00653.101394,E,0.039,0.00,230808,,,A*53", "$GPVTG,0.00,T,,M,0.039,N,0.072,K,A*32",
            "$GPGGA,102128.000,5129.0623,N,00632.2910,E,1,4,1.31,29.7,M,47.4,M,,*6D"};
        for (String sentence : real) {
            String body = Nmea.body(sentence);
            assertEquals(sentence.substring(1, sentence.length() - 3), body);
            assertEquals(sentence + "\r\n", Nmea.sentence(body));
        }
    }

    @Test
    public void aDamagedFrameHasNoBody() {
        String[] damaged = {"", "$", "*00", "$PMTK220,1000*1E", "PMTK220,1000*1F", "$PMTK220,1000", "$PMTK220,1000*1G", "$PMTK220,1000*1F "};
        for (String line : damaged) {
            assertNull(line, Nmea.body(line));
        }
        assertEquals("lower case is read, too", "PMTK220,1000", Nmea.body("$PMTK220,1000*1f"));
    }

    @Test
    public void commandsAreThoseOfTheManual() {
        assertEquals("$PMTK000*32\r\n", Nmea.sentence(Pmtk.TEST.body()));
        assertEquals("$PMTK220,200*2C\r\n", Nmea.sentence(Pmtk.SET_PERIOD.body(200)));
        assertEquals("$PMTK251,38400*27\r\n", Nmea.sentence(Pmtk.SET_BAUD.body(38400)));
        assertEquals("$PMTK300,1000,0,0,0,0*1C\r\n", Nmea.sentence(Pmtk.SET_FIX_INTERVAL.body(1000, 0, 0, 0, 0)));
        assertEquals("$PMTK314,-1*04\r\n", Nmea.sentence(Pmtk.SET_OUTPUT.body(-1)));
        assertEquals("$PMTK605*31\r\n", Nmea.sentence(Pmtk.QUERY_RELEASE.body()));
        assertEquals("$PMTK001,220,3*30\r\n", Nmea.sentence(Pmtk.ACKNOWLEDGE.body(220, 3)));
        assertEquals("$PMTK705,AXN_1.30,0000,20090609,*20\r\n", Nmea.sentence(Pmtk.RELEASE.body("AXN_1.30", "0000", "20090609", "")));
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
        assertEquals(52.21636892, Nmea.degrees("5212.982135", Nmea.LATITUDE_DIGITS), 1e-8);
        assertEquals(80.864998, Nmea.degrees("08051.8999", Nmea.LONGITUDE_DIGITS), 1e-6);
    }

    @Test(expected = IllegalArgumentException.class)
    public void anEmptyFieldIsNoCoordinate() {
        Nmea.degrees("", Nmea.LATITUDE_DIGITS);
    }

    @Test
    public void numbersHaveAPointAndNoNegativeZero() {
        assertEquals("-0.5", Nmea.number(-0.5, 1));
        assertEquals("0.0", Nmea.number(-0.01, 1));
        assertEquals("1234.50", Nmea.number(1234.5, 2));
    }
}
