// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.Arrays;
import java.util.function.BiConsumer;
import java.util.function.DoubleSupplier;
import org.SEAR.POJOs.Gravity;
import org.SEAR.camera.Appearances;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.raycast.BeamScene;
import org.SEAR.robot.surface.SurfaceColors;
import org.SEAR.sensors.Earth;
import org.SEAR.sensors.Truth;

/** Ground truth of one robot after each step. Simulation thread. */
public final class RobotTruth implements Truth {
    /** Displacement from the last counted position at which the path grows, metres: larger than any vibration. */
    private static final double DEAD_BAND = 1e-4;
    /** The same for the heading, radians. */
    private static final double TURN_DEAD_BAND = 2e-4;

    private final Body body;
    private final PartTouches touches;
    private final RaycastScenes scenes;
    private final SurfaceColors colors;
    private final int owner;
    private final Earth earth;
    private final long epochMillis;
    private final WorkerPool workers;
    private final double[] velocity = new double[3];
    private final double[] angular = new double[3];
    private final double[] point = new double[3];
    private final Appearances looks;
    private long step;
    private double path;
    private double turned;
    private Pose anchor;
    private double heading;
    private DoubleSupplier encoders;
    private DoubleSupplier gravity = () -> Gravity.EARTH;
    private BiConsumer<String, double[]> wrenches;

    public RobotTruth(RobotBuilder from, RaycastScenes scenes, SurfaceColors colors, int owner, Earth earth,
        long epochMillis, WorkerPool workers) {
        this.body = from.body;
        this.touches = new PartTouches(from);
        this.scenes = scenes;
        this.colors = colors;
        looks = shape -> colors.skin(scenes.solid(shape));
        this.owner = owner;
        this.earth = earth;
        this.epochMillis = epochMillis;
        this.workers = workers;
    }

    /** @param ofWorld present gravity, m/s^2 downwards; that of the Earth before this call */
    public void setGravity(DoubleSupplier ofWorld) {
        gravity = ofWorld;
    }

    /** @param ofJoints copies the force and torque of a joint by its name, see {@link Truth#wrench} */
    public void setWrenches(BiConsumer<String, double[]> ofJoints) {
        wrenches = ofJoints;
    }

    @Override
    public void wrench(String joint, double[] into) {
        wrenches.accept(joint, into);
    }

    void restart() {
        step = 0;
        path = 0;
        turned = 0;
        anchor = body.getPose();
        heading = heading(anchor);
        Arrays.fill(velocity, 0);
        Arrays.fill(angular, 0);
    }

    /** Notes a teleport, which is not part of the distance travelled. */
    void moved() {
        anchor = body.getPose();
        heading = heading(anchor);
    }

    /**
     * Takes over the state after a step.
     * @param awake whether the robot may have moved
     */
    public void update(long newStep, boolean awake) {
        step = newStep;
        if (!awake) {
            Arrays.fill(velocity, 0);
            Arrays.fill(angular, 0);
            return;
        }
        Pose pose = body.getPose();
        body.velocityAt(pose.x, pose.y, pose.z, velocity);
        body.angularVelocity(angular);
        double dx = pose.x - anchor.x;
        double dy = pose.y - anchor.y;
        double dz = pose.z - anchor.z;
        double now = heading(pose);
        double turn = Math.IEEEremainder(now - heading, 2 * Math.PI);
        if (Math.abs(turn) > TURN_DEAD_BAND) {
            turned += turn;
            heading = now;
        }
        if (dx * dx + dy * dy + dz * dz > DEAD_BAND * DEAD_BAND) {
            path += (along(anchor, dx, dy, dz) + along(pose, dx, dy, dz)) / 2;
            anchor = pose;
        }
    }

    /** Returns the component of a displacement along the pose's forward axis. */
    private static double along(Pose pose, double dx, double dy, double dz) {
        return dx * 2 * (pose.qx * pose.qz + pose.qw * pose.qy) + dy * 2 * (pose.qy * pose.qz - pose.qw * pose.qx)
            + dz * (1 - 2 * (pose.qx * pose.qx + pose.qy * pose.qy));
    }

    /** Returns the angle of the forward axis about +y, radians, + counter-clockwise from above. */
    private static double heading(Pose pose) {
        return Math.atan2(2 * (pose.qx * pose.qz + pose.qw * pose.qy), 1 - 2 * (pose.qx * pose.qx + pose.qy * pose.qy));
    }

    /** Change of heading since the start, radians, not wrapped. */
    double turned() {
        return turned;
    }

    @Override
    public long step() {
        return step;
    }

    @Override
    public double time() {
        return step * TimeStep.SECONDS;
    }

    @Override
    public double stepLength() {
        return TimeStep.SECONDS;
    }

    @Override
    public long epochMillis() {
        return epochMillis;
    }

    @Override
    public Pose body() {
        return body.getPose();
    }

    @Override
    public double[] velocity() {
        return velocity;
    }

    @Override
    public double[] angularVelocity() {
        return angular;
    }

    @Override
    public double path() {
        return path;
    }

    @Override
    public double odometry() {
        return encoders == null ? path : encoders.getAsDouble();
    }

    /** @param newEncoders distance by the encoders, metres; null for that of the body */
    void setEncoders(DoubleSupplier newEncoders) {
        encoders = newEncoders;
    }

    @Override
    public double gravity() {
        return gravity.getAsDouble();
    }

    @Override
    public Earth earth() {
        return earth;
    }

    @Override
    public BeamScene scene() {
        return scenes.beams;
    }

    @Override
    public int owner() {
        return owner;
    }

    PartTouches touches() {
        return touches;
    }

    @Override
    public boolean isTouched(String part) {
        return touches.is(part);
    }

    @Override
    public double contactForce(String part) {
        return touches.force(part);
    }

    @Override
    public boolean isGround(int shape) {
        return scenes.isGround(shape);
    }

    @Override
    public int color(int shape, double x, double y, double z) {
        point[0] = x;
        point[1] = y;
        point[2] = z;
        scenes.beams.toFrame(shape, point);
        return colors.at(scenes.solid(shape), point);
    }

    @Override
    public BeamScene sight() {
        return scenes.ground;
    }

    @Override
    public Appearances looks() {
        return looks;
    }

    @Override
    public WorkerPool workers() {
        return workers;
    }

    @Override
    public String objectName(int shape) {
        return scenes.body(shape).name;
    }
}
