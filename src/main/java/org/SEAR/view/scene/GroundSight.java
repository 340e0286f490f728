package org.SEAR.view.scene;

import com.jme3.math.Vector3f;
import org.SEAR.geometry.HeightGrid;

/** What a terrain hides from a camera, and where the camera has to stay above it. Window thread only. */
final class GroundSight {
    /** Steps in which a line of sight is followed; the first ones are the shortest. */
    private static final int STEPS = 96;

    private final HeightGrid field;
    private final float room;

    /** @param room metres that a camera keeps from the ground */
    GroundSight(HeightGrid field, float room) {
        this.field = field;
        this.room = room;
    }

    /** The longer side, metres. */
    float extent() {
        return (float) Math.max((field.rows - 1) * field.spacingX, (field.columns - 1) * field.spacingZ);
    }

    /** Metres above the ground; 0 beside it. */
    float above(Vector3f place) {
        double height = field.height(place.x, place.z);
        return Double.isNaN(height) ? 0 : (float) Math.max(0, place.y - height);
    }

    /** Puts a place that is in or close to the ground above it. */
    void lift(Vector3f place) {
        double height = field.height(place.x, place.z);
        if (place.y < height + room) {
            place.y = (float) height + room;
        }
    }

    /**
     * How far one gets from a place above the ground, metres.
     *
     * @param most metres
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
