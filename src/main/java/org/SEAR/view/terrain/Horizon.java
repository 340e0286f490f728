// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import com.jme3.math.FastMath;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;

/**
 * Occlusion horizon: the steepest rise of the ground seen from the camera up to each distance, in narrow columns side
 * by side. Ground below it is hidden. Allocates nothing per frame.
 */
final class Horizon {
    private static final int COLUMNS = 512;
    /** Sample distances: the first one, metres, and the ratio between successive ones. */
    private static final float FIRST = 3;
    private static final float RATIO = 1.15f;
    private static final int STEPS = 85;
    /** Views with less horizontal component have columns too far apart: no ground counts as hidden. */
    private static final float MIN_AHEAD = 0.4f;

    private final TilePyramid ground;
    private final float highest;
    private final float[] distances = new float[STEPS];
    /** Greatest slope (rise over run) so far, by column and step. */
    private final float[] slopes = new float[COLUMNS * STEPS];
    private final Vector3f eye = new Vector3f(Float.NaN, 0, 0);
    private final Vector3f ahead = new Vector3f();
    /** Half width of all columns at one metre ahead, metres. */
    private float half;

    /** @param highest maximum elevation of the field, metres */
    Horizon(TilePyramid ground, float highest) {
        this.ground = ground;
        this.highest = highest;
        distances[0] = FIRST;
        for (int step = 1; step < STEPS; step++) {
            distances[step] = RATIO * distances[step - 1];
        }
    }

    /** Updates the horizon for a camera. A camera above all ground disables it. */
    void look(Camera camera) {
        Vector3f direction = camera.getDirection();
        float level = FastMath.sqrt(direction.x * direction.x + direction.z * direction.z);
        float least = level - Math.abs(direction.y) * camera.getFrustumTop() / camera.getFrustumNear();
        float wide = least < MIN_AHEAD || camera.getLocation().y > highest ? 0
            : camera.getFrustumRight() / camera.getFrustumNear() / least;
        float x = level > 0 ? direction.x / level : 0;
        float z = level > 0 ? direction.z / level : 0;
        if (wide == half && camera.getLocation().equals(eye) && x == ahead.x && z == ahead.z) {
            return;
        }
        eye.set(camera.getLocation());
        ahead.set(x, 0, z);
        half = wide;
        for (int column = 0; half > 0 && column < COLUMNS; column++) {
            survey(column);
        }
    }

    private void survey(int column) {
        float aside = half * (2f * column / (COLUMNS - 1) - 1);
        float length = FastMath.sqrt(1 + aside * aside);
        float x = (ahead.x - aside * ahead.z) / length;
        float z = (ahead.z + aside * ahead.x) / length;
        float steepest = Float.NEGATIVE_INFINITY;
        for (int step = 0; step < STEPS; step++) {
            double height = ground.surely(eye.x + distances[step] * x, eye.z + distances[step] * z, distances[step]);
            float slope = (float) (height - eye.y) / distances[step];
            steepest = slope > steepest ? slope : steepest;
            slopes[column * STEPS + step] = steepest;
        }
    }

    /**
     * Returns whether the ground in front of a box hides it completely.
     * @param margin slope by which the horizon must exceed the box
     */
    boolean hides(float south, float north, float west, float east, float high, float margin) {
        float nearX = Math.max(0, Math.max(south - eye.x, eye.x - north));
        float nearZ = Math.max(0, Math.max(west - eye.z, eye.z - east));
        float nearest = FastMath.sqrt(nearX * nearX + nearZ * nearZ);
        if (half == 0 || nearest < FIRST) {
            return false;
        }
        float right = Float.POSITIVE_INFINITY;
        float left = Float.NEGATIVE_INFINITY;
        float farthest = nearest;
        for (int corner = 0; corner < 4; corner++) {
            float x = (corner < 2 ? south : north) - eye.x;
            float z = (corner % 2 == 0 ? west : east) - eye.z;
            float forward = x * ahead.x + z * ahead.z;
            if (forward <= 0) {
                return false;
            }
            float aside = (z * ahead.x - x * ahead.z) / forward;
            right = Math.min(right, aside);
            left = Math.max(left, aside);
            farthest = Math.max(farthest, FastMath.sqrt(x * x + z * z));
        }
        float rise = high - eye.y;
        float slope = rise / (rise > 0 ? nearest : farthest) + margin;
        int first = Math.max(0, (int) Math.floor(column(right)) - 1);
        int last = Math.min(COLUMNS - 1, (int) Math.ceil(column(left)) + 1);
        int step = Math.min(STEPS - 1, (int) (FastMath.log(nearest / FIRST) / FastMath.log(RATIO)));
        step -= distances[step] > nearest ? 1 : 0;
        for (int column = first; column <= last; column++) {
            if (!(slopes[column * STEPS + Math.max(0, step)] > slope)) {
                return false;
            }
        }
        return first <= last;
    }

    private float column(float aside) {
        return FastMath.clamp((aside / half + 1) / 2, -1, 2) * (COLUMNS - 1);
    }
}
