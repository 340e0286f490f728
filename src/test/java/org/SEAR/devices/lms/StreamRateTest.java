// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import static org.junit.Assert.assertEquals;

import org.SEAR.Slow;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Variant;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Stream rates match SICK's table for each speed and variant. */
@Category(Slow.class)
public class StreamRateTest {
    private static final double[][] HERTZ = {
        {100, 1, 4.416, 8.342, 15.02, 75.1}, {100, 0.5, 2.208, 4.171, 7.508, 37.5},
            {100, 0.25, 1.173, 2.346, 4.692, 18.77},
        {180, 1, 2.503, 5.005, 9.384, 75.1}, {180, 0.5, 1.294, 2.503, 4.692, 37.5}};
    private static final double SECONDS = 60;

    @Test
    public void wholeScans() {
        for (double[] row : HERTZ) {
            Variant variant = Variant.of((int) row[0], (int) (row[1] * 100));
            for (Baud baud : Baud.values()) {
                double expected = row[2 + baud.ordinal()];
                double measured = rate(variant, baud, "02 00 02 00 20 24 34 08", variant.getValues() * 2 + 10);
                assertEquals(variant + " at " + baud, expected, measured, expected * 0.05);
            }
        }
    }

    @Test
    public void meansAndPartsAndRanges() {
        assertEquals(1 / (5 * 2 * 0.01332),
            rate(Variant.V180_HALF, Baud.B500000, "02 00 03 00 20 26 05 79 3E", 733), 0.3);
        assertEquals(9.384, rate(Variant.V180_HALF, Baud.B38400, "02 00 02 00 20 2A 3A 08", 371), 0.4);
        assertEquals(1 / (11 * 2 * 0.01332),
            rate(Variant.V180_HALF, Baud.B19200, "02 00 06 00 20 27 1B 00 2B 01 FF FE", 560), 0.2);
    }

    private static double rate(Variant variant, Baud baud, String start, int size) {
        FakeContext line = new FakeContext();
        line.sensor = new FakeScanner();
        line.attach(new Lms200(new PowerOnSettings(variant, baud.getRate(), false, Identity.LMS200_30106), line));
        line.host(start);
        line.pass(2);
        line.take();
        line.pass(SECONDS);
        double rate = line.take().length / (double) size / SECONDS;
        line.host("02 00 02 00 20 25 35 08");
        line.pass(2);
        line.take();
        line.pass(2);
        assertEquals("silent after the stop", 0, line.take().length);
        return rate;
    }
}
