// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertTrue;

import org.junit.Rule;
import org.junit.Test;

/** Time for faces with many corners grows with their number only. */
public class ObjClockTest {
    @Rule
    public final FormatRule project = new FormatRule();

    /** Milliseconds for a face whose corners are all the same. */
    private double millis(int corners) throws Exception {
        String obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf" + " 1".repeat(corners) + "\n";
        project.with("m.obj", obj);
        long start = System.nanoTime();
        project.load("m.obj").hasArea(0.5);
        return (System.nanoTime() - start) / 1e6;
    }

    @Test
    public void tenTimesTheCornersTakeNotAHundredTimesTheTime() throws Exception {
        millis(20_000);
        double few = millis(20_000);
        double many = millis(200_000);
        assertTrue(few + " ms, then " + many + " ms", many < 40 * few + 200);
    }
}
