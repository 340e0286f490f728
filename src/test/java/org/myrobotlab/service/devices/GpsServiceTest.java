// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.ubx.NavPvt;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.SEAR.protocol.ubx.UbxTest;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.myrobotlab.service.FarEnd;
import org.myrobotlab.service.GPS;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;

/** The GPS service with a receiver that sends recordings of real ones. */
public class GpsServiceTest {
    private static final String PORT = "/dev/test_gps";
    private static final String SOUTH_CAROLINA =
        Nmea.sentence("GPGGA,120000.000,3336.6000,N,08051.8999,W,1,8,1.0,182.5,M,-33.0,M,,");
    private static final String NO_FIX = "$GPGGA,235946.005,8960.000000,N,00000.000000,E,0,0,,137.000,M,"
        + "13.000,M,,*49\r\n";

    private FarEnd receiver;
    private GPS gps;
    private Heard heard;

    @Before
    public void start() throws Exception {
        receiver = new FarEnd(PORT, text -> null);
        gps = (GPS) Runtime.start("testGps", "GPS");
        heard = (Heard) Runtime.start("positions", "Heard");
        gps.addListener("publishStatus", "positions", "onStatus");
    }

    @After
    public void release() {
        Runtime.releaseService("testGps");
        Runtime.releaseService("positions");
        receiver.close();
    }

    private void say(String text) {
        receiver.send(text.getBytes(StandardCharsets.US_ASCII));
    }

    private static void assertPosition(double[] expected, Object position, double tolerance) {
        assertArrayEquals(expected, Arrays.stream((Double[]) position).mapToDouble(Double::doubleValue)
            .toArray(), tolerance);
    }

    @Test
    public void theFieldsAreThoseOfTheDissertation() throws Exception {
        gps.addListener("publishGGAData", "positions", "onValue");
        gps.connect(PORT);
        say(SOUTH_CAROLINA);
        String[] tokens = (String[]) heard.await(1).get(0);
        assertEquals("$GPGGA", tokens[0]);
        assertEquals("3336.6000", tokens[2]);
        assertEquals("-08051.8999", tokens[4]);
        assertEquals("182.5", tokens[9]);
    }

    @Test
    public void positionsAreInDecimalDegrees() throws Exception {
        gps.addListener("publishGPS", "positions", "onValue");
        gps.connect(PORT, 38400);
        say("garbage\u0001$GPGGA,1200" + SOUTH_CAROLINA);
        Object position = heard.await(1).get(0);
        assertPosition(new double[] {33.61, -80.86499833, 182.5}, position, 1e-8);
        assertEquals(1, gps.getDamagedCount());
    }

    /** Sentences of a marine receiver: 14 fields, without altitude. */
    @Test
    public void aMissingAltitudeIsNone() throws Exception {
        gps.addListener("publishGPS", "positions", "onValue");
        gps.connect(PORT);
        say(Nmea.sentence("IIGGA,071500,3336.6,N,08051.9,W,1,7,1.4,,M,,M,"));
        Double[] position = (Double[]) heard.await(1).get(0);
        assertEquals(33.61, position[0], 1e-9);
        assertEquals(-80.865, position[1], 1e-9);
        assertNull(position[2]);
        assertNull(gps.getLastFix().altitude);
    }

    @Test
    public void aReceiverWithoutGgaHasPositionsAndTime() throws Exception {
        gps.addListener("publishGGAData", "positions", "onValue");
        gps.connect(PORT);
        say(Nmea.sentence("GNRMC,071500.00,A,3336.6,N,08051.9,W,0.1,0.0,040526,,,A"));
        say(Nmea.sentence("GNRMC,071501.00,A,3336.6,N,08051.9,W,0.1,0.0,040526,,,A"));
        String[] tokens = (String[]) heard.await(2).get(1);
        assertEquals("$GNRMC", tokens[0]);
        assertEquals("-08051.9", tokens[4]);
        assertEquals("2026-05-04T07:15:01.00Z", gps.getTime());
        assertTrue(gps.hasFix());
    }

    /** The calls of MyRobotLab's Gps. */
    @Test
    public void fencesAndDistancesNeedNoReceiver() {
        assertTrue(gps.checkInside(gps.setPointGeoFence(33.61, -80.865, 50), 33.6104, -80.865));
        assertFalse(gps.checkInside(gps.setPointGeoFence(gps.setPoint(33.61, -80.865), 50),
            gps.setPoint(33.6106, -80.865)));
        assertTrue(gps.checkInside(gps.setPolygonGeoFence(
            Arrays.asList(gps.setPoint(0, 0), gps.setPoint(10, 0), gps.setPoint(0, 10))), 1, 1));
        assertEquals(111319.49, gps.calculateDistance(0, 10, 0, 11), 0.01);
        assertEquals(111319.49, gps.calculateDistance(gps.setPoint(0, 10), gps.setPoint(0, 11)), 0.01);
        assertEquals("the second point is None, legal: one of setPoint",
            assertThrows(IllegalArgumentException.class, () -> gps.calculateDistance(gps.setPoint(0, 0), null))
                .getMessage());
        assertThrows(IllegalArgumentException.class, () -> gps.checkInside(null, 1, 1));
        assertThrows(IllegalArgumentException.class, () -> gps.convertNMEAToDegrees(null));
        assertEquals(-80.865, gps.convertNMEAToDegrees("-08051.9000"), 1e-9);
        assertEquals(33.61, gps.convertNMEAToDegrees("3336.6"), 1e-9);
    }

    /** Another receiver may be at the other end. */
    @Test
    public void aNewConnectionKnowsNothingOfTheFormer() throws Exception {
        gps.addListener("publishSentence", "positions", "onValue");
        gps.connect(PORT);
        say("$GPGGA,1*00\r\n" + Nmea.sentence("PMTK705,AXN_1.30,0000,20090609,")
            + Nmea.sentence("GPZDA,071500,04,05,2026,00,00") + SOUTH_CAROLINA);
        heard.await(3);
        assertTrue(heard.awaitStatus("has a fix"));
        assertEquals("MT3329", gps.getConfig().model);
        gps.setBaud(9600);
        gps.connect(PORT, 38400);
        assertNull(gps.getLastFix());
        assertNull(gps.getTime());
        assertNull(gps.getFirmware());
        assertFalse(gps.hasFix());
        assertEquals(0, gps.getSentenceCount());
        assertEquals(0, gps.getDamagedCount());
        assertEquals("the model that was set", "FV-M8", gps.getConfig().model);
        say(SOUTH_CAROLINA);
        heard.await(4);
        String query = FarEnd.hex("$PMTK605*31\r\n".getBytes(StandardCharsets.US_ASCII));
        int queries = 0;
        // commands sent in short succession may arrive in one piece
        for (int pieces = 2; pieces <= 3 && queries < 2; pieces++) {
            queries = String.join(" ", receiver.await(pieces)).split(query, -1).length - 1;
        }
        assertEquals("the firmware is queried at each connection", 2, queries);
    }

    @Test
    public void lossOfTheFixIsReportedOnce() throws Exception {
        gps.connect(PORT);
        say(SOUTH_CAROLINA + NO_FIX + NO_FIX);
        assertTrue(heard.awaitStatus("warn: testGps has lost its fix"));
        say(SOUTH_CAROLINA);
        assertTrue(heard.awaitStatus("has a fix"));
        assertEquals(1, heard.getStatuses().stream().filter(status -> status.contains("has lost its fix")).count());
    }

    @Test
    public void aPortClosedByAnotherIsNoticed() throws Exception {
        gps.connect(PORT);
        ((Serial) Runtime.getService("testGps.serial")).disconnect();
        assertTrue(heard.awaitStatus("port " + PORT + " was closed: testGps reconnects"));
        assertFalse(gps.isConnected());
        try {
            gps.sendCommand("PMTK605");
            fail("sent");
        } catch (IllegalStateException e) {
            assertEquals("testGps is not connected: call connect(port) first", e.getMessage());
        }
        gps.addListener("publishGPS", "positions", "onValue");
        gps.reconnectSerial();
        say(SOUTH_CAROLINA);
        assertEquals(1, heard.await(1).size());
    }

    @Test
    public void illegalCharactersOfASentenceAreNotSent() throws Exception {
        gps.connect(PORT);
        String legal = ", legal: printable ASCII without $, * and check sum, which are added, as \"PMTK220,200\"";
        for (String body : new String[] {"", "$PMTK605", "PMTK605*31", "PMTK605\r\n", "PMTK\u00fc"}) {
            assertEquals("the command is \"" + body + "\"" + legal,
                assertThrows(IllegalArgumentException.class, () -> gps.sendCommand(body)).getMessage());
        }
        assertEquals("the command is null" + legal,
            assertThrows(IllegalArgumentException.class, () -> gps.sendCommand(null)).getMessage());
    }

    @Test
    public void silenceIsReported() throws Exception {
        gps.connect(PORT);
        assertTrue(heard.awaitStatus("no data from testGps on port " + PORT + " at 38400 baud"));
        say(SOUTH_CAROLINA);
        assertTrue(heard.awaitStatus("sends again"));
    }

    @Test
    public void theBaudRateIsSetWithTheReceiversOwnCommand() throws Exception {
        gps.connect(PORT, 38400);
        gps.setBaud(9600);
        assertEquals(FarEnd.hex("$PMTK251,9600*17\r\n".getBytes(StandardCharsets.US_ASCII)),
            String.join(" ", receiver.await(1)));
        assertEquals(9600, gps.getConfig().baud);
    }

    @Test
    public void theModelIsTheOneTheReceiverNames() throws Exception {
        gps.addListener("publishSentence", "positions", "onValue");
        gps.connect(PORT);
        say(SOUTH_CAROLINA);
        assertEquals(FarEnd.hex("$PMTK605*31\r\n".getBytes(StandardCharsets.US_ASCII)),
            String.join(" ", receiver.await(1)));
        say(Nmea.sentence("PMTK705,AXN_1.30,0000,20090609,"));
        heard.await(2);
        assertEquals("AXN_1.30", gps.getFirmware());
        assertEquals("MT3329", gps.getConfig().model);
        say(SOUTH_CAROLINA + Nmea.sentence("PMTK705,MTK3301_1.0,0000,20090609,"));
        assertEquals(4, heard.await(4).size());
        assertEquals("MT3301", gps.getConfig().model);
        assertEquals("asked once", 1, receiver.await(1).size());
    }

    @Test
    public void aPlainReceiverGetsNoQueries() throws Exception {
        gps.addListener("publishSentence", "positions", "onValue");
        gps.setModel("NMEA");
        gps.connect(PORT);
        say(SOUTH_CAROLINA + SOUTH_CAROLINA);
        assertEquals(2, heard.await(2).size());
        assertEquals(0, receiver.await(0).size());
        assertEquals("NMEA", gps.getConfig().model);
    }

    /** Spelling of MyRobotLab's former GPS service. */
    @Test
    public void aModelMayBeWrittenWithAnUnderscore() {
        gps.setModel("FV_M8");
        assertEquals("FV-M8", gps.getConfig().model);
    }

    @Test
    public void unknownModelsAndRatesNameTheKnownOnes() {
        for (Runnable wrong : Arrays.<Runnable>asList(() -> gps.setModel("FV-M9"), () -> gps.setBaud(12345))) {
            try {
                wrong.run();
                fail("taken");
            } catch (IllegalArgumentException e) {
                assertTrue(e.getMessage(), e.getMessage().contains("legal: ["));
            }
        }
        assertFalse(gps.isConnected());
    }

    @Test
    public void aUbxSolutionIsReadLikeASentence() throws Exception {
        gps.addListener("publishGGAData", "positions", "onValue");
        gps.connect(PORT);
        receiver.send(Bytes.bytes("B5 62" + UbxTest.PVT));
        String[] tokens = (String[]) heard.await(1).get(0);
        assertEquals("$GNGGA", tokens[0]);
        assertEquals("085000.80", tokens[1]);
        assertEquals("-3454.3735780", tokens[2]);
        assertEquals("13836.4871820", tokens[4]);
        assertEquals("differential", "2", tokens[6]);
        assertEquals("28.895", tokens[9]);
        assertEquals("-3.471", tokens[11]);
        assertTrue(gps.hasFix());
        assertEquals(-34.9062263, gps.getLastFix().latitude, 1e-9);
        assertEquals(1, gps.getSentenceCount());
        assertEquals("what seemed to begin a frame", 1, gps.getDamagedCount());
    }

    /** The receiver sends both with each fix. */
    @Test
    public void aSentenceAndASolutionOfTheSameTimeAreOnePosition() throws Exception {
        gps.addListener("publishGPS", "positions", "onValue");
        gps.connect(PORT);
        receiver.send(Bytes.bytes(UbxTest.PVT));
        say(Nmea.sentence("GNGGA,085000.80,3454.37358,S,13836.48718,E,1,14,1.45,28.9,M,-3.5,M,,"));
        say(Nmea.sentence("GNGGA,085001.80,3454.37358,S,13836.48718,E,1,14,1.45,28.9,M,-3.5,M,,"));
        assertPosition(new double[] {-34.9062263, 138.6081197, 28.895}, heard.await(1).get(0), 1e-9);
        assertPosition(new double[] {-34.906226333, 138.608119667, 28.9}, heard.await(2).get(1), 1e-9);
        assertEquals(2, heard.await(2).size());
    }

    @Test
    public void aNeoM8nIsConfiguredByUbx() throws Exception {
        gps.setModel("u-blox");
        assertEquals("NEO-M8N", gps.getConfig().model);
        assertEquals(9600, gps.getConfig().baud);
        gps.connect(PORT);
        say(SOUTH_CAROLINA);
        assertEquals("B5 62 0A 04 00 00 0E 34", receiver.await(1).get(0));
        gps.setRate(5);
        assertEquals("B5 62 06 08 06 00 C8 00 01 00 01 00 DE 6A", receiver.await(2).get(1));
        gps.sendUbx("06 01 01 07 01");
        assertEquals("B5 62 06 01 03 00 01 07 01 13 51", receiver.await(3).get(2));
        gps.setBaud(115200);
        assertEquals("B5 62 06 00 14 00 01 00 00 00 D0 08 00 00 00 C2 01 00 07 00 03 00 00 00 00 00 C0 7E",
            receiver.await(4).get(3));
        receiver.send(Bytes.bytes("B5 62 05 00 02 00 06 8A 97 BC"));
        assertTrue(heard.awaitStatus("warn: testGps refused a command: message 06 8A"));
        byte[] version = Arrays.copyOf("EXT CORE 3.01 (107900)".getBytes(StandardCharsets.US_ASCII), 40);
        gps.addListener("publishSentence", "positions", "onValue");
        receiver.send(new UbxFrame(UbxMessage.MON_VER, version).toBytes());
        say(SOUTH_CAROLINA);
        heard.await(1);
        assertEquals("EXT CORE 3.01 (107900)", gps.getFirmware());
    }

    @Test
    public void theRateIsSetWithTheReceiversOwnCommand() throws Exception {
        gps.connect(PORT);
        gps.setRate(5);
        assertEquals(FarEnd.hex("$PMTK220,200*2C\r\n".getBytes(StandardCharsets.US_ASCII)),
            String.join(" ", receiver.await(1)));
        assertEquals("GPS rate is 20.0 Hz, legal for FV-M8: 0.1 to 5.0", refusal(() -> gps.setRate(20)));
        assertTrue(refusal(() -> gps.sendUbx("06 0"))
            .startsWith("UBX message is \"06 0\", legal: class, number and payload"));
        gps.setModel("NMEA");
        assertTrue(refusal(() -> gps.setRate(1)).contains("model NMEA takes no commands"));
    }

    private static String refusal(Runnable call) {
        try {
            call.run();
        } catch (IllegalArgumentException e) {
            return e.getMessage();
        }
        return "taken";
    }

    @Test
    public void randomBytesNeverStopIt() throws Exception {
        Random random = new Random(Fuzz.SEED);
        gps.connect(PORT);
        byte[] block = new byte[1000];
        for (int done = 0; done < Fuzz.BYTES; done += block.length) {
            random.nextBytes(block);
            for (int i = 0; i + 1 < block.length; i += 50) {
                block[i] = (byte) 0xB5;
                block[i + 1] = 0x62;
            }
            gps.onBytes(block);
            byte[] payload = new byte[NavPvt.LEAST + random.nextInt(20)];
            random.nextBytes(payload);
            gps.onBytes(new UbxFrame(UbxMessage.NAV_PVT, payload).toBytes());
        }
        gps.onBytes(new byte[UbxFrame.MOST + UbxFrame.OVERHEAD]);
        gps.addListener("publishGPS", "positions", "onValue");
        say(SOUTH_CAROLINA);
        assertTrue("seed " + Fuzz.SEED, heard.awaitValue(position -> ((Double[]) position)[2] == 182.5));
    }
}
