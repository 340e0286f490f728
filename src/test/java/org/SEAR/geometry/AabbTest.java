// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Axis-aligned bounding boxes: containment and overlap. */
public class AabbTest {
    private static Aabb box(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
        return new Aabb().add(minX, minY, minZ).add(maxX, maxY, maxZ);
    }

    @Test
    public void anEmptyBoxOverlapsAndContainsNothing() {
        Aabb all = box(-1e300, -1e300, -1e300, 1e300, 1e300, 1e300);
        assertFalse(new Aabb().overlaps(all));
        assertFalse(all.overlaps(new Aabb()));
        assertFalse(new Aabb().contains(box(0, 0, 0, 0, 0, 0)));
        assertFalse(box(1, 2, 3, 4, 5, 6).clear().overlaps(all));
    }

    @Test
    public void containsPointsAddedInAnyOrder() {
        assertEquals("(-1.0, 0.0, 2.0) to (4.0, 5.0, 6.0)", new Aabb().add(4, 0, 6).add(-1, 5, 2).toString());
        assertEquals("(-3.0, 0.0, 0.0) to (2.0, 7.0, 1.0)", box(0, 0, 0, 1, 7, 1).add(box(-3, 1, 0, 2, 2, 1))
            .toString());
    }

    @Test
    public void boxesThatTouchOverlap() {
        Aabb one = box(0, 0, 0, 1, 1, 1);
        for (int axis = 0; axis < 3; axis++) {
            Aabb beside = box(0, 0, 0, 1, 1, 1).set(axis, 1, 2);
            assertTrue(one.overlaps(beside) && beside.overlaps(one));
            beside.set(axis, 1.25, 2);
            assertFalse(one.overlaps(beside) || beside.overlaps(one));
            assertFalse(one.overlaps(beside, 0.125));
            assertTrue(one.overlaps(beside, 0.25) && beside.overlaps(one, 0.25));
            beside.set(axis, -2, -0.25);
            assertFalse(one.overlaps(beside, 0.125));
            assertTrue(one.overlaps(beside, 0.25));
        }
    }

    @Test
    public void containsBoxesThatStickOutNowhere() {
        Aabb one = box(0, 0, 0, 1, 1, 1);
        assertTrue(one.contains(one));
        for (int axis = 0; axis < 3; axis++) {
            assertFalse(one.contains(box(0, 0, 0, 1, 1, 1).set(axis, 0.5, 1.5)));
            assertFalse(one.contains(box(0, 0, 0, 1, 1, 1).set(axis, -0.5, 0.5)));
            assertTrue(one.contains(box(0, 0, 0, 1, 1, 1).set(axis, 0.25, 0.75)));
        }
    }

    @Test
    public void growsToAllSidesAndSweepsToOneSide() {
        assertEquals("(-2.0, -1.0, 0.0) to (3.0, 4.0, 5.0)", box(-1, 0, 1, 2, 3, 4).grow(1).toString());
        assertEquals("(-1.0, -2.0, 1.0) to (5.0, 3.0, 4.0)", box(-1, 0, 1, 2, 3, 4).sweep(3, -2, 0).toString());
    }

    @Test
    public void hasEightCorners() {
        Aabb one = box(0, 1, 2, 3, 4, 5);
        Aabb around = new Aabb();
        for (int i = 0; i < 8; i++) {
            Vec3 corner = one.corner(i, new Vec3());
            around.add(corner.x, corner.y, corner.z);
            assertEquals(i % 2 == 0 ? 0 : 3, corner.x, 0);
            assertEquals(i / 2 % 2 == 0 ? 1 : 4, corner.y, 0);
            assertEquals(i < 4 ? 2 : 5, corner.z, 0);
        }
        assertEquals(one.toString(), around.toString());
    }
}
