package org.SEAR.robot;

import org.SEAR.POJOs.Parameter;
import org.SEAR.POJOs.Servo;
import org.SEAR.devices.ServoHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.project.ObjectPose;

/** A servo that turns at its speed to the angle that it was given. Simulation thread. */
final class ServoDrive implements ServoHardware {
    private final Servo object;
    private final String robot;
    private final Pose axis;
    private double wanted;
    private double angle;

    ServoDrive(Servo object, String robot) {
        this.object = object;
        this.robot = robot;
        this.axis = ObjectPose.of(object);
        restart();
    }

    /** As at the start: at 0 degrees, or as near to it as it can be. */
    void restart() {
        wanted = Math.max(object.getMinAngle(), Math.min(object.getMaxAngle(), 0));
        angle = wanted;
    }

    @Override
    public String getName() {
        return object.getName();
    }

    @Override
    public void setAngle(double degrees) {
        if (!(degrees >= object.getMinAngle() && degrees <= object.getMaxAngle())) {
            throw new IllegalArgumentException("servo " + object.getName() + " of robot " + robot + ": angle is " + degrees + ", legal: "
                + Parameter.format(object.getMinAngle()) + " to " + Parameter.format(object.getMaxAngle()) + " deg");
        }
        wanted = degrees;
    }

    /** Whether it is on its way. */
    boolean isMoving() {
        return angle != wanted;
    }

    /** Turns for one step. */
    void step() {
        double most = object.getSpeed() * TimeStep.SECONDS;
        angle = Math.abs(wanted - angle) <= most ? wanted : angle + Math.copySign(most, wanted - angle);
    }

    /** What it does to what is on it, in the frame of what it is on itself: a turn about its axis. */
    Pose turn() {
        double half = Math.toRadians(angle) / 2;
        double[] along = axis.rotate(0, Math.sin(half), 0);
        Pose turned = new Pose(0, 0, 0, along[0], along[1], along[2], Math.cos(half));
        double[] moved = turned.rotate(axis.x, axis.y, axis.z);
        return new Pose(axis.x - moved[0], axis.y - moved[1], axis.z - moved[2], turned.qx, turned.qy, turned.qz, turned.qw);
    }

    @Override
    public double getAngle() {
        return angle;
    }

    @Override
    public double getMinAngle() {
        return object.getMinAngle();
    }

    @Override
    public double getMaxAngle() {
        return object.getMaxAngle();
    }
}
