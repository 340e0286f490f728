// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.Hit;

/**
 * An ultrasonic, infrared, radar, sonar or laser range sensor: the nearest hit along the rays of all its cones, metres;
 * no return if no ray hits within its length. Below the product's minimum range the reading is that range. Infrared
 * beams also return a voltage of the true distance, so it folds back below the minimum range. Parts of the sensor's own
 * robot are invisible unless the object says otherwise. Errors apply along the ray.
 */
public final class DistanceSensor extends Sensor<DistanceReading> {
    private final BeamPattern pattern;
    private final Distance distance;
    private final double minRange;
    private final VoltageCurve voltages;
    private final Rotation rotation = new Rotation();
    private final Hit hit = new Hit();
    private final double[] directions;
    private final double[] shortest = new double[1];
    private double nearest;

    /** @param seed random seed of the simulation */
    public DistanceSensor(Distance parameters, long seed) {
        super(parameters, seed, 1);
        this.distance = parameters;
        this.pattern = BeamPattern.of(parameters.getCones());
        this.directions = new double[3 * pattern.size()];
        Beam shape = parameters.getShape();
        this.minRange = shape == null ? 0 : shape.getMinRange();
        this.voltages = new VoltageCurve(shape == null ? Collections.emptyList() : shape.getVoltages());
    }

    @Override
    public List<String> warnings(Truth truth) {
        GroundCheck check = new GroundCheck(truth, distance.isSeesOwnRobot() ? BeamScene.WORLD : truth.owner(),
            pose(truth));
        for (int line = 0; line < pattern.size(); line++) {
            check.look(pattern.getX(line), pattern.getY(line), pattern.getZ(line), pattern.getRange(line));
        }
        return check.warnings(getName());
    }

    @Override
    protected DistanceReading measure(Truth truth) {
        Pose pose = pose(truth);
        rotation.set(pose);
        int ignored = distance.isSeesOwnRobot() ? BeamScene.WORLD : truth.owner();
        int line = errors.drops(truth.step(), 0) ? -1 : nearestLine(truth.scene(), pose, ignored);
        if (line < 0) {
            return new DistanceReading(voltages.at(Double.POSITIVE_INFINITY), pattern, pose);
        }
        double dx = directionX(line);
        double dy = directionY(line);
        double dz = directionZ(line);
        truth.scene().cast(pose.x, pose.y, pose.z, dx, dy, dz, pattern.getRange(line), ignored, hit);
        double[] point = {pose.x + nearest * dx, pose.y + nearest * dy, pose.z + nearest * dz};
        double measured = Math.max(0, Math.min(pattern.getMaxRange(), errors.apply(nearest, truth.step(), 0, 0)));
        return new DistanceReading(Math.max(minRange, measured), voltages.at(measured), pattern, pose, line, point,
            truth.objectName(hit.shape));
    }

    /** Returns the ray with the nearest hit, the first of several, or -1; stores the distance in {@link #nearest}. */
    private int nearestLine(BeamScene scene, Pose pose, int ignored) {
        for (int line = 0; line < pattern.size(); line++) {
            directions[3 * line] = directionX(line);
            directions[3 * line + 1] = directionY(line);
            directions[3 * line + 2] = directionZ(line);
        }
        int found = scene.castBundle(pose.x, pose.y, pose.z, directions, pattern.ranges(), ignored, shortest);
        nearest = shortest[0];
        return found;
    }

    private double directionX(int line) {
        return rotation.outX(pattern.getX(line), pattern.getY(line), pattern.getZ(line));
    }

    private double directionY(int line) {
        return rotation.outY(pattern.getX(line), pattern.getY(line), pattern.getZ(line));
    }

    private double directionZ(int line) {
        return rotation.outZ(pattern.getX(line), pattern.getY(line), pattern.getZ(line));
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Distance.class;
        }

        @Override
        public String description() {
            return "distance to the nearest object in nested cones of rays: m (scripts get the longest ray's length "
                + "without a hit)";
        }

        @Override
        public String unit() {
            return "m";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new DistanceSensor((Distance) parameters, seed);
        }
    }
}
