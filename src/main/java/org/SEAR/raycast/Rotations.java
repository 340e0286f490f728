package org.SEAR.raycast;

/** Rotation matrices in flat arrays. */
final class Rotations {
    private Rotations() {
    }

    /** Writes the nine numbers, row by row, of the matrix that a unit quaternion stands for. */
    static void matrix(double x, double y, double z, double w, double[] out, int at) {
        out[at] = 1 - 2 * (y * y + z * z);
        out[at + 1] = 2 * (x * y - z * w);
        out[at + 2] = 2 * (x * z + y * w);
        out[at + 3] = 2 * (x * y + z * w);
        out[at + 4] = 1 - 2 * (x * x + z * z);
        out[at + 5] = 2 * (y * z - x * w);
        out[at + 6] = 2 * (x * z - y * w);
        out[at + 7] = 2 * (y * z + x * w);
        out[at + 8] = 1 - 2 * (x * x + y * y);
    }
}
