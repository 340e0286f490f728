// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.Hit;

/**
 * Checks whether a forward beam hits the ground, so that the sensor reads the ground wherever nothing is nearer.
 * Simulation thread.
 */
final class GroundCheck {
    /** Sine of 45 degrees: a sensor that points down more steeply is meant to see the ground. */
    private static final double STEEP = Math.sin(Math.PI / 4);

    private final Truth truth;
    private final int ignored;
    private final Pose pose;
    private final Rotation rotation = new Rotation();
    private final Hit hit = new Hit();
    private double nearest = Double.POSITIVE_INFINITY;
    private int ground = -1;

    /**
     * @param ignored owner whose parts the sensor does not see
     * @param pose pose of the sensor in the world
     */
    GroundCheck(Truth truth, int ignored, Pose pose) {
        this.truth = truth;
        this.ignored = ignored;
        this.pose = pose;
        rotation.set(pose);
    }

    /** Casts a ray: a unit direction in the sensor's frame and a length in metres. */
    void look(double x, double y, double z, double range) {
        double distance = truth.scene().cast(pose.x, pose.y, pose.z, rotation.outX(x, y, z), rotation.outY(x, y, z),
            rotation.outZ(x, y, z), range, ignored, hit);
        if (distance < nearest && truth.isGround(hit.shape)) {
            nearest = distance;
            ground = hit.shape;
        }
    }

    /** Returns a warning with the ground's name and a remedy, or nothing. */
    List<String> warnings(String sensor) {
        if (ground < 0 || rotation.outY(0, 0, 1) < -STEEP) {
            return List.of();
        }
        return List.of(String.format(Locale.ROOT, "sensor %s sees the ground (%s) at %.2f m wherever nothing is "
            + "nearer: mount it higher, tilt it"
            + " up (%s.rotate(-20, 0, 0)), or hide the ground: sear.setGroundVisible(False) for all, or "
            + "setVisibleToSensors(False) of the object", sensor, truth.objectName(ground), nearest,
                sensor.substring(sensor.lastIndexOf('/') + 1)));
    }
}
