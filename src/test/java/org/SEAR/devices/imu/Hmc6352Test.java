// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.imu;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.devices.FakeContext;
import org.SEAR.sensors.Quantity;
import org.junit.Before;
import org.junit.Test;

/** The compass's answers to the commands of its data sheet and to the dissertation's Listing 9. */
public class Hmc6352Test {
    private FakeContext line;
    private Hmc6352 compass;

    @Before
    public void power() {
        line = new FakeContext();
        compass = line.attach(new Hmc6352(9600, line));
    }

    private String ask(String hex) {
        line.take();
        line.host(hex);
        return line.takeHex();
    }

    private String heading(double degrees) {
        line.reading = new Quantity(degrees);
        return ask("41");
    }

    @Test
    public void headingsAreTenthsOfADegreeHighByteFirst() {
        assertEquals("03 84", heading(90));
        assertEquals("00 00", heading(0));
        assertEquals("07 0D", heading(-179.5));
        assertEquals("in steps of half a degree", "0D FC", heading(-1.9 - 0.2));
        assertEquals("0E 0B", heading(-0.5));
        assertEquals("all round is none", "00 00", heading(-0.2));
    }

    @Test
    public void anAnswerTakesSixMilliseconds() {
        line.reading = new Quantity(12);
        line.host("41");
        assertEquals(line.now + 0.006, line.times.get(0), 1e-9);
    }

    /** Joins the bytes like receiveMessage of Listing 9. */
    @Test
    public void listingNineGetsItsHeading() {
        line.reading = new Quantity(-90);
        line.take();
        line.host(0x8E);
        line.host(0x2F);
        byte[] buffer = line.take();
        assertEquals(2, buffer.length);
        int result = ((buffer[0] & 0xff) << 8) + (buffer[1] & 0xff);
        assertEquals(270, (float) result / 10, 0);
        assertEquals("a sensor that it hasn't", "", ask("8E 2B"));
    }

    @Test
    public void asleepItDoesNotAnswer() {
        heading(10);
        assertEquals("", ask("53 41"));
        assertTrue(compass.status(), compass.status().contains("asleep"));
        assertEquals("00 64", ask("57 41"));
        assertEquals("nor while it is calibrated", "", ask("43 41"));
        assertEquals("00 64", ask("45 41"));
    }

    @Test
    public void itsMemoriesAreReadAndWritten() {
        assertEquals("42", ask("72 00"));
        assertEquals("06", ask("72 07"));
        assertEquals("50", ask("67 74"));
        assertEquals("not obeyed as a command", "", ask("47 74 41"));
        assertEquals("41", ask("67 74"));
        compass.powerOff();
        compass.powerOn(line.now);
        assertEquals("not saved", "50", ask("67 74"));
        ask("47 74 72 4C");
        compass.powerOn(line.now);
        assertEquals("saved", "72", ask("67 74"));
        ask("77 05 09");
        assertEquals("09", ask("72 05"));
        compass.reset();
        assertEquals("as delivered", "01", ask("72 05"));
    }

    @Test
    public void aDroppedReadingRepeatsThePreviousOne() {
        assertEquals("03 84", heading(90));
        assertEquals("03 84", heading(Double.NaN));
    }
}
