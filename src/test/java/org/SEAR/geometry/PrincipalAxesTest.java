// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;

import java.util.Arrays;
import java.util.Random;
import org.junit.Test;

/** {@link PrincipalAxes} and {@link InertiaTensor}. */
public class PrincipalAxesTest {
    private static final double EXACT = 1e-13;

    private static Pose rotation(Random random) {
        return Pose.ofDegrees(0, 0, 0, 360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
    }

    private static double[] elements(InertiaTensor tensor) {
        return new double[] {tensor.xx, tensor.yy, tensor.zz, tensor.xy, tensor.xz, tensor.yz};
    }

    private static double[] sorted(double... values) {
        Arrays.sort(values);
        return values;
    }

    @Test
    public void aDiagonalTensorKeepsItsAxes() {
        PrincipalAxes axes = PrincipalAxes.of(new InertiaTensor(3, 1, 2));
        assertSame(Pose.IDENTITY, axes.frame);
        assertArrayEquals(new double[] {3, 1, 2}, new double[] {axes.x, axes.y, axes.z}, 0);
    }

    /** Rounding in a model's file does not turn the axes of a cube. */
    @Test
    public void roundingTurnsNoAxes() {
        assertSame(Pose.IDENTITY, PrincipalAxes.of(new InertiaTensor(1, 1, 1, 1e-11, -1e-11, 1e-11)).frame);
    }

    @Test
    public void axesTurnedByLittleKeepTheirNames() {
        PrincipalAxes axes = PrincipalAxes.of(new InertiaTensor(3, 1, 2).inParent(Pose.ofDegrees(0, 0, 0, 5, -7, 3)));
        assertArrayEquals(new double[] {3, 1, 2}, new double[] {axes.x, axes.y, axes.z}, EXACT);
        double[] x = axes.frame.rotate(1, 0, 0);
        assertArrayEquals(Pose.ofDegrees(0, 0, 0, 5, -7, 3).rotate(1, 0, 0), x, EXACT);
    }

    @Test
    public void momentsAreThoseOfARandomlyTurnedBody() {
        Random random = new Random(4);
        for (int i = 0; i < 2000; i++) {
            double a = 1e-6 + random.nextDouble();
            double b = i % 5 == 0 ? a : 1e-6 + random.nextDouble();
            double c = i % 10 == 0 ? a : Math.abs(a - b) + Math.min(a, b) * random.nextDouble();
            InertiaTensor turned = new InertiaTensor(a, b, c).inParent(rotation(random));
            PrincipalAxes axes = PrincipalAxes.of(turned);
            assertArrayEquals("case " + i, sorted(a, b, c), sorted(axes.x, axes.y, axes.z), EXACT);
            assertArrayEquals("case " + i, elements(turned),
                elements(new InertiaTensor(axes.x, axes.y, axes.z).inParent(axes.frame)), EXACT);
            double[] own = axes.frame.rotate(1, 0, 0);
            assertEquals("case " + i, axes.x, turned.about(own[0], own[1], own[2]), EXACT);
        }
    }

    @Test
    public void aDisplacedTensorIsThatOfTheParallelAxisTheorem() {
        InertiaTensor tensor = new InertiaTensor(1, 2, 2.5).displaced(4, 0.1, 0.2, -0.3);
        assertArrayEquals(new double[] {1 + 4 * 0.13, 2 + 4 * 0.1, 2.5 + 4 * 0.05, -4 * 0.02, 4 * 0.03, 4 * 0.06},
            elements(tensor), EXACT);
    }
}
