// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.Arrays;

/** Convex polygons cut by planes across coordinate axes (Sutherland and Hodgman 1974). */
final class ClippedPolygon {
    private ClippedPolygon() {
    }

    /** Sets {@code into} to the least x, y, z and the greatest x, y, z. */
    static void bounds(double[] polygon, double[] into) {
        for (int axis = 0; axis < 3; axis++) {
            double low = polygon[axis];
            double high = low;
            for (int i = axis + 3; i < polygon.length; i += 3) {
                low = Math.min(low, polygon[i]);
                high = Math.max(high, polygon[i]);
            }
            into[axis] = low;
            into[axis + 3] = high;
        }
    }

    /**
     * Returns the part of a polygon on one side of a plane.
     * @param sign 1 for the side of smaller coordinates, -1 for the other
     * @param near distance within which a corner is on the plane, metres
     * @return null if no corner is beyond {@code near} on that side, unless {@code near} is 0
     */
    static double[] clip(double[] polygon, int axis, double at, double sign, double near) {
        boolean any = false;
        boolean all = true;
        for (int i = axis; i < polygon.length; i += 3) {
            double height = sign * (polygon[i] - at);
            any |= near > 0 ? height < -near : height <= 0;
            all &= height <= near;
        }
        if (!any || all) {
            return any ? polygon : null;
        }
        double[] kept = new double[polygon.length + 6];
        int size = 0;
        for (int i = 0; i < polygon.length; i += 3) {
            int next = (i + 3) % polygon.length;
            double height = sign * (polygon[i + axis] - at);
            double other = sign * (polygon[next + axis] - at);
            if (height <= near) {
                kept = Arrays.copyOf(kept, Math.max(kept.length, size + 6));
                System.arraycopy(polygon, i, kept, size, 3);
                size += 3;
            }
            if (height > near && other < -near || height < -near && other > near) {
                kept = Arrays.copyOf(kept, Math.max(kept.length, size + 6));
                double share = height / (height - other);
                for (int k = 0; k < 3; k++) {
                    kept[size + k] = k == axis ? at : polygon[i + k] + share * (polygon[next + k] - polygon[i + k]);
                }
                size += 3;
            }
        }
        return Arrays.copyOf(kept, size);
    }
}
