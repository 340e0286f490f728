package org.myrobotlab.service;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.SEAR.protocol.nmea.Nmea;

/** The GPS service with a receiver that says what real ones said. */
public class GpsServiceTest {
    private static final String PORT = "/dev/test_gps";
    private static final String SOUTH_CAROLINA = Nmea.sentence("GPGGA,120000.000,3336.6000,N,08051.8999,W,1,8,1.0,182.5,M,-33.0,M,,");
    private static final String NO_FIX = "$GPGGA,235946.005,8960.000000,N,00000.000000,E,0,0,,137.000,M,13.000,M,,*49\r\n";

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
        double[] position = (double[]) heard.await(1).get(0);
        assertArrayEquals(new double[] {33.61, -80.86499833, 182.5}, position, 1e-8);
        assertEquals(1, gps.getDamagedCount());
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
    public void aPortThatSomebodyElseClosesIsNoticed() throws Exception {
        gps.connect(PORT);
        ((Serial) Runtime.getService("testGps.serial")).disconnect();
        assertTrue(heard.awaitStatus("port " + PORT + " was closed: reconnectSerial() when it is back"));
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
        assertEquals(FarEnd.hex("$PMTK251,9600*17\r\n".getBytes(StandardCharsets.US_ASCII)), String.join(" ", receiver.await(1)));
        assertEquals(9600, gps.getConfig().baud);
    }

    @Test
    public void theModelIsTheOneTheReceiverNames() throws Exception {
        gps.addListener("publishSentence", "positions", "onValue");
        gps.connect(PORT);
        say(SOUTH_CAROLINA);
        assertEquals(FarEnd.hex("$PMTK605*31\r\n".getBytes(StandardCharsets.US_ASCII)), String.join(" ", receiver.await(1)));
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
    public void aPlainReceiverIsAskedNothing() throws Exception {
        gps.addListener("publishSentence", "positions", "onValue");
        gps.setModel("NMEA");
        gps.connect(PORT);
        say(SOUTH_CAROLINA + SOUTH_CAROLINA);
        assertEquals(2, heard.await(2).size());
        assertEquals(0, receiver.await(0).size());
        assertEquals("NMEA", gps.getConfig().model);
    }

    /** As MyRobotLab's own GPS service of old wrote it. */
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
}
