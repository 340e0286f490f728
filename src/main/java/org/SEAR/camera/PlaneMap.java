// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/**
 * Linear texture map of a plane: u = U p + u0, likewise v, from the coordinates of three corners. Immutable, any
 * thread.
 */
final class PlaneMap {
    private final double[] map = new double[8];

    /**
     * @param corners x, y and z of three corners, metres
     * @param places u and v of each
     */
    PlaneMap(double[] corners, double[] places) {
        double[] e = {corners[3] - corners[0], corners[4] - corners[1], corners[5] - corners[2]};
        double[] f = {corners[6] - corners[0], corners[7] - corners[1], corners[8] - corners[2]};
        double[] n = cross(e, f);
        double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        double[] toE = cross(f, n);
        double[] toF = cross(n, e);
        for (int k = 0; k < 2 && square > 0; k++) {
            double alongE = places[2 + k] - places[k];
            double alongF = places[4 + k] - places[k];
            map[4 * k + 3] = places[k];
            for (int axis = 0; axis < 3; axis++) {
                map[4 * k + axis] = (alongE * toE[axis] + alongF * toF[axis]) / square;
                map[4 * k + 3] -= map[4 * k + axis] * corners[axis];
            }
        }
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** Sets the colour of a hit. */
    void look(Paint paint, SurfaceHit s) {
        double[] m = map;
        paint.look(m[0] * s.x + m[1] * s.y + m[2] * s.z + m[3], m[4] * s.x + m[5] * s.y + m[6] * s.z + m[7],
            m[0] * s.rightX + m[1] * s.rightY + m[2] * s.rightZ, m[4] * s.rightX + m[5] * s.rightY + m[6] * s.rightZ,
            m[0] * s.downX + m[1] * s.downY + m[2] * s.downZ, m[4] * s.downX + m[5] * s.downY + m[6] * s.downZ, s);
    }
}
