// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Tipping angles of robots compared with closed forms. */
public class StabilityTest {
    private static final double EXACT = 1e-9;
    /** A rectangle 0.4 m wide and 0.6 m long, and a foot inside. */
    private static final double[][] FEET = {{0.2, -0.1, 0.3}, {-0.2, -0.1, 0.3}, {0.05, -0.1, 0}, {0.2, -0.1, -0.3},
        {-0.2, -0.1, -0.3}};

    private static Stability at(double x, double y, double z, double[]... feet) {
        return new Stability(new double[] {x, y, z}, feet, false, 9.81);
    }

    @Test
    public void aRectangleTipsOverItsNearestEdge() {
        Stability middle = at(0, 0.3, 0, FEET);
        assertEquals(Math.toDegrees(Math.atan2(0.2, 0.4)), middle.degrees, EXACT);
        assertEquals(4, middle.getSupport().length);
        assertEquals("tips over to the left on a slope of 14 degrees, or when it brakes or turns with more than 2.5 "
            + "m/s\u00b2. Put weight lower or"
            + " further inwards, or its wheels further apart", at(0.1, 0.3, 0, FEET).getWords());
        assertEquals(Math.toDegrees(Math.atan2(0.05, 0.4)), at(-0.15, 0.3, 0, FEET).degrees, EXACT);
        assertTrue(at(-0.15, 0.3, 0, FEET).getWords().startsWith("tips over to the right on a slope of 7 degrees"));
        assertTrue(at(0, 0.3, 0.25, FEET).getWords().startsWith("tips over forwards on a slope of 7 degrees"));
        assertTrue(at(0, 0.3, -0.25, FEET).getWords().startsWith("tips over backwards on a slope of 7 degrees"));
        assertArrayEquals(new double[] {0.1, 0.3, 0}, at(0.1, 0.3, 0, FEET).getCentre(), 0);
    }

    /** Two wheels in front, a caster behind, where the sides converge. */
    @Test
    public void aTriangleTipsOverASlantedSide() {
        double[][] feet = {{0.1, 0, 0}, {-0.1, 0, 0}, {0, 0, -0.15}};
        double side = Math.hypot(0.1, 0.15);
        double room = 0.1 * 0.1 / side;
        Stability stability = at(0, 0.1, -0.05, feet);
        assertEquals(Math.toDegrees(Math.atan2(0.05, 0.1)), stability.degrees, EXACT);
        assertEquals(Math.toDegrees(Math.atan2(room / 2, 0.1)), at(0, 0.1, -0.1, feet).degrees, EXACT);
        assertEquals(3, stability.getSupport().length);
        assertTrue(at(0.01, 0.1, -0.1, feet).getWords().startsWith("tips over backwards to the left on a slope of 1"));
        assertTrue(at(-0.01, 0.1, -0.1, feet).getWords()
            .startsWith("tips over backwards to the right on a slope of 1"));
    }

    @Test
    public void outsideOfItsWheelsItFallsOver() {
        Stability stability = at(0, 0.3, 0.35, FEET);
        assertEquals(-Math.toDegrees(Math.atan2(0.05, 0.4)), stability.degrees, EXACT);
        assertTrue(stability.isCritical());
        assertEquals("falls over forwards at rest: its centre of mass at x 0.000, y 0.300, z 0.350 of its "
            + "frame is 0.050 m outside its wheels. Put weight lower or further inwards, or its wheels further apart",
                stability.getWords());
    }

    @Test
    public void fifteenDegreesAreEnough() {
        double height = 0.2 / Math.tan(Math.toRadians(Stability.CRITICAL));
        assertFalse(at(0, height - 0.1001, 0, FEET).isCritical());
        assertTrue(at(0, height - 0.0999, 0, FEET).isCritical());
    }

    @Test
    public void aLineSupportsNothing() {
        for (double[][] feet : new double[][][] {{}, {{0, 0, 0}}, {{0.1, 0, 0}, {-0.1, 0, 0}},
            {{0, 0, 0.2}, {0, 0, -0.2}, {0, 0, 0}, {0, 0, 0.1}}}) {
            Stability stability = at(0, 0.1, 0, feet);
            assertEquals(Double.NaN, stability.degrees, 0);
            assertEquals(0, stability.getSupport().length);
            assertFalse(stability.isCritical());
            assertEquals("", stability.getWords());
        }
    }

    /** An edge between wheels of different heights: the height of the centre of mass above the edge counts. */
    @Test
    public void wheelsAtDifferentHeights() {
        double[][] feet = {{0.2, -0.1, 0.3}, {-0.3, 0, 0.3}, {0.2, -0.3, -0.3}, {-0.3, 0, -0.3}};
        assertEquals(Math.toDegrees(Math.atan2(0.2, 0.3)), at(0, 0.1, 0, feet).degrees, EXACT);
    }
}
