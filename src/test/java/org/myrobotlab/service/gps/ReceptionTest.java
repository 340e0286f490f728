// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.ubx.NavPvt;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.junit.Test;

/** Each moment gives one fix, whichever sentences a receiver sends, and in whichever order. */
public class ReceptionTest {
    private static final String PLACE = ",0830.0000,N,11515.0000,E,";

    private final List<String> fixes = new ArrayList<>();
    private final List<String> invalid = new ArrayList<>();
    private final Reception reception = new Reception(new Reception.Listener() {
        @Override
        public void onSentence(String sentence) {
        }

        @Override
        public void onUbx(UbxFrame frame) {
        }

        @Override
        public void onFix(Fix fix) {
            fixes.add(fix.tokens[0].substring(1) + " " + fix.utc + (fix.hasFix() ? "" : " none"));
        }

        @Override
        public void onInvalid(String reason) {
            invalid.add(reason);
        }
    });

    private void feed(String... bodies) {
        for (String body : bodies) {
            reception.feed(Nmea.sentence(body).getBytes(StandardCharsets.US_ASCII));
        }
    }

    private void gga(String time) {
        feed("GPGGA," + time + PLACE + "1,08,1.0,20.5,M,5.5,M,,");
    }

    private void rmc(String time) {
        feed("GPRMC," + time + ",A" + PLACE + "0.1,0.0,040526,,,A");
    }

    private void gll(String time) {
        feed("GPGLL" + PLACE + time + ",A,A");
    }

    /** As MediaTek's receivers do. */
    @Test
    public void ofGgaAndRmcGgaIsTaken() {
        for (String time : new String[] {"000001", "000002"}) {
            gga(time);
            rmc(time);
            gll(time);
        }
        assertEquals("[GPGGA 000001, GPGGA 000002]", fixes.toString());
    }

    /** As u-blox' receivers do. */
    @Test
    public void rmcWaitsForGga() {
        for (String time : new String[] {"000001.00", "000002.00"}) {
            rmc(time);
            gga(time);
            gll(time);
        }
        assertEquals("[GPGGA 000001.00, GPGGA 000002.00]", fixes.toString());
    }

    @Test
    public void withoutGgaRmcIsTaken() {
        rmc("000001");
        assertEquals("a GGA may follow", "[]", fixes.toString());
        rmc("000002");
        gll("000002");
        rmc("000003");
        assertEquals("[GPRMC 000001, GPRMC 000002, GPRMC 000003]", fixes.toString());
    }

    @Test
    public void eachSentenceMayHaveItsOwnTime() {
        rmc("000001");
        gll("000002");
        rmc("000003");
        gga("000004");
        rmc("000005");
        gll("000006");
        rmc("000007");
        assertEquals("[GPRMC 000001, GPGLL 000002, GPRMC 000003, GPGGA 000004, GPRMC 000005, GPGLL 000006, "
            + "GPRMC 000007]", fixes.toString());
    }

    @Test
    public void aSentenceOfTimeEndsAMoment() {
        rmc("000001");
        feed("GPZDA,000001,04,05,2026,00,00");
        assertEquals("[]", fixes.toString());
        feed("GPZDA,000002,04,05,2026,00,00");
        assertEquals("[GPRMC 000001]", fixes.toString());
    }

    /** A GNS has more than RMC; receivers send one for each constellation. */
    @Test
    public void theFullestSentenceOfAMomentIsTaken() {
        for (String time : new String[] {"000001", "000002", "000003"}) {
            rmc(time);
            feed("GPGNS," + time + PLACE + "A,06,0.8,30.25,5.5,,", "GLGNS," + time + PLACE + "A,05,0.8,30.25,5.5,,");
        }
        assertEquals("[GPGNS 000001, GPGNS 000002, GPGNS 000003]", fixes.toString());
    }

    @Test
    public void theConstellationWithAFixIsTaken() {
        feed("GPGGA,000001,,,,,0,00,,,M,,M,,", "BDGGA,000001" + PLACE + "1,05,1.0,20.5,M,5.5,M,,",
            "GAGGA,000001" + PLACE + "1,05,1.0,20.5,M,5.5,M,,");
        assertEquals("[GPGGA 000001 none, BDGGA 000001]", fixes.toString());
    }

    /** Some receivers cut the hundredths in one sentence and round them in another. */
    @Test
    public void timesMayDifferByAHundredth() {
        gga("000001.08");
        gll("000001.076");
        gga("000002.31");
        gll("000002.305");
        assertEquals("[GPGGA 000001.08, GPGGA 000002.31]", fixes.toString());
    }

    @Test
    public void aLostFixIsReportedByAnySentence() {
        rmc("000001");
        rmc("000002");
        feed("GPRMC,000003,V,,,,,,,040526,,,N");
        assertEquals("[GPRMC 000001, GPRMC 000002, GPRMC 000003 none]", fixes.toString());
        assertNull(reception.getLastFix().latitude);
    }

    @Test
    public void theDateComesFromRmcZdaAndUbx() {
        assertNull(reception.getTime());
        feed("GPRMC,235946.005,V,,,,,,,050180,,,N", "GPZDA,,,,,00,00", "GNGGA,000001.00,,,,,0,00,,,M,,M,,");
        assertNull("a receiver without a fix invents a date", reception.getTime());
        feed("GNZDA,101011.20,07,11,2026,00,00");
        assertEquals("2026-11-07T10:10:11.20Z", reception.getTime());
        rmc("101012");
        assertEquals("2026-05-04T10:10:12Z", reception.getTime());
        feed("GPRMC,101013,A" + PLACE + "0.1,0.0,040599,,,A");
        assertEquals("1999-05-04T10:10:13Z", reception.getTime());
        reception.feed(new UbxFrame(UbxMessage.NAV_PVT, solution(0, 0)).toBytes());
        assertEquals("2026-12-31T23:59:59.50Z", reception.getTime());
        assertEquals("235959.50", reception.getLastFix().utc);
    }

    /** Returns a NAV-PVT at 52.5 degrees north, 13.25 degrees west and 34 m. */
    private static byte[] solution(int type, int flags) {
        byte[] payload = new byte[NavPvt.SIZE];
        byte[] date = {(byte) 0xEA, 7, 12, 31, 23, 59, 59, 3};
        System.arraycopy(date, 0, payload, 4, date.length);
        put(payload, 16, 500000000);
        payload[20] = (byte) type;
        payload[21] = (byte) flags;
        payload[23] = 9;
        put(payload, 24, -132500000);
        put(payload, 28, 525000000);
        put(payload, 36, 34000);
        return payload;
    }

    private static void put(byte[] payload, int at, int value) {
        for (int i = 0; i < 4; i++) {
            payload[at + i] = (byte) (value >> 8 * i);
        }
    }

    @Test
    public void ubxFixesHaveTheirKind() {
        Fix fix = PvtFix.of(solution(3, 1));
        assertEquals(52.5, fix.latitude, 1e-9);
        assertEquals(-13.25, fix.longitude, 1e-9);
        assertEquals(34, fix.altitude, 1e-9);
        assertEquals(9, fix.satellites.intValue());
        assertNull("without height", PvtFix.of(solution(2, 1)).altitude);
        assertTrue(PvtFix.of(solution(2, 1)).hasFix());
        assertEquals("time only, at a surveyed place", 7, PvtFix.of(solution(5, 1)).quality);
        assertEquals("outside the limits", 0, PvtFix.of(solution(3, 0)).quality);
    }

    @Test
    public void unusableSentencesAreNamed() {
        feed("GPGLL,9130.0,N,11515.0,E,101010,A");
        assertEquals("[GLL sentence: $GPGLL,9130.0,N,11515.0,E,101010,A*21 (coordinate \"9130.0\" is 91.5 degrees, "
            + "legal: 0 to 90.0)]", invalid.toString());
        feed("GPRMC", "GPGSA,A,1", "GPZDA,1", "GPTXT,01,01,02,hello");
        assertEquals(1, invalid.size());
        assertEquals(5, reception.getCount());
    }
}
