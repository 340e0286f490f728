package org.SEAR.sensors;

import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.Hit;

/** Whether a beam that looks ahead meets the ground, so that a sensor reads that wherever nothing is nearer. Simulation thread. */
final class GroundCheck {
    /** A sensor that looks down more steeply is meant to see the ground: sine of 45 degrees. */
    private static final double STEEP = Math.sin(Math.PI / 4);

    private final Truth truth;
    private final int ignored;
    private final Pose pose;
    private final Rotation rotation = new Rotation();
    private final Hit hit = new Hit();
    private double nearest = Double.POSITIVE_INFINITY;
    private int ground = -1;

    /**
     * @param ignored owner whose parts the sensor doesn't see
     * @param pose of the sensor in the world
     */
    GroundCheck(Truth truth, int ignored, Pose pose) {
        this.truth = truth;
        this.ignored = ignored;
        this.pose = pose;
        rotation.set(pose);
    }

    /** Looks along a line: its direction in the sensor's frame, unit length, and its length in metres. */
    void look(double x, double y, double z, double range) {
        double distance = truth.scene().cast(pose.x, pose.y, pose.z, rotation.outX(x, y, z), rotation.outY(x, y, z), rotation.outZ(x, y, z), range,
            ignored, hit);
        if (distance < nearest && truth.isGround(hit.shape)) {
            nearest = distance;
            ground = hit.shape;
        }
    }

    /** What the user should know: nothing, or a warning that names the ground and says what to do. */
    List<String> warnings(String sensor) {
        if (ground < 0 || rotation.outY(0, 0, 1) < -STEEP) {
            return List.of();
        }
        return List.of(String.format(Locale.ROOT, "sensor %s sees the ground (%s) at %.2f m, and reads that wherever nothing is nearer: mount it"
            + " higher or tilt it up (%s.rotate(-20, 0, 0)), or let beams pass through the ground: sear.setGroundVisible(False) for all, or"
            + " setVisibleToSensors(False) of the object", sensor, truth.objectName(ground), nearest, sensor.substring(sensor.lastIndexOf('/') + 1)));
    }
}
