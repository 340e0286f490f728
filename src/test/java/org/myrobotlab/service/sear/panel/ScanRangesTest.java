// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;

import java.util.Base64;
import java.util.Random;
import org.junit.Test;

/** Scans in the format for panels. */
public class ScanRangesTest {
    private static final double TENTH = 1e-4;

    private static int number(byte[] bytes, int at) {
        return (bytes[2 * at] & 255) + 256 * (bytes[2 * at + 1] & 255);
    }

    /** @return the ranges that a panel decodes from a text, metres; infinite for none */
    private static double[] read(String text) {
        byte[] bytes = Base64.getDecoder().decode(text);
        double[] metres = new double[bytes.length / 2 - 1];
        for (int i = 0; i < metres.length; i++) {
            int number = number(bytes, i + 1);
            metres[i] = number == 65535 ? Double.POSITIVE_INFINITY : number * number(bytes, 0) * TENTH;
        }
        return metres;
    }

    @Test
    public void theUnitFollowsTheLongestRange() {
        double[] near = read(new ScanRanges(new double[] {0, 0.0001, 6.5534, Double.POSITIVE_INFINITY, Double.NaN})
            .text());
        assertEquals(5, near.length);
        assertEquals(0, near[0], 0);
        assertEquals(0.0001, near[1], 1e-12);
        assertEquals(6.5534, near[2], 1e-12);
        assertEquals(Double.POSITIVE_INFINITY, near[3], 0);
        assertEquals(Double.POSITIVE_INFINITY, near[4], 0);
        double[] far = read(new ScanRanges(new double[] {250.123, 0.5}).text());
        assertEquals("within half of 3.9 mm", 250.123, far[0], 0.002);
        assertEquals(0.5, far[1], 0.002);
    }

    @Test
    public void anyScanIsReadWithinHalfItsUnit() {
        Random random = new Random(7);
        for (int i = 0; i < 200; i++) {
            double reach = Math.pow(10, 4 * random.nextDouble() - 1.5);
            double[] exact = random.doubles(50, 0, reach).toArray();
            double[] read = read(new ScanRanges(exact).text());
            for (int beam = 0; beam < exact.length; beam++) {
                assertEquals("of " + reach, exact[beam], read[beam], Math.max(TENTH, reach / 65534 + TENTH) / 2 + 1e-9);
            }
        }
    }

    @Test
    public void noReturnDiffersFromTheFurthestRange() {
        assertNotEquals(new ScanRanges(new double[] {8}).text(),
            new ScanRanges(new double[] {Double.POSITIVE_INFINITY}).text());
        assertEquals(0, read(new ScanRanges(new double[0]).text()).length);
    }
}
