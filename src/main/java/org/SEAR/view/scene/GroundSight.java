// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.math.Vector3f;
import org.SEAR.geometry.HeightGrid;

/** Occlusion of a camera by terrain, and its minimum height above it. Window thread only. */
final class GroundSight {
    /** Samples along a line of sight; the nearest ones are the densest. */
    private static final int STEPS = 96;

    private final HeightGrid field;
    private final float room;

    /** @param room minimum distance of a camera from the ground, metres */
    GroundSight(HeightGrid field, float room) {
        this.field = field;
        this.room = room;
    }

    /** Returns the length of the longer side, metres. */
    float extent() {
        return (float) Math.max((field.rows - 1) * field.spacingX, (field.columns - 1) * field.spacingZ);
    }

    /** Returns the height above the ground, metres; 0 outside the terrain. */
    float above(Vector3f place) {
        double height = field.height(place.x, place.z);
        return Double.isNaN(height) ? 0 : (float) Math.max(0, place.y - height);
    }

    /** Lifts a position to the minimum distance above the ground. */
    void lift(Vector3f place) {
        double height = field.height(place.x, place.z);
        if (place.y < height + room) {
            place.y = (float) height + room;
        }
    }

    /**
     * Returns the distance to the ground from a position above it, metres.
     * @param most maximum distance, metres
     */
    float free(Vector3f from, Vector3f direction, float most) {
        float clear = 0;
        for (int step = 1; step <= STEPS; step++) {
            float share = (float) step / STEPS;
            float way = most * share * share;
            double height = field.height(from.x + way * direction.x, from.z + way * direction.z);
            if (from.y + way * direction.y < height) {
                return clear;
            }
            clear = way;
        }
        return most;
    }
}
