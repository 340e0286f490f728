// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

/** Hardware whose state a test sets. Lengths in metres, angles in radians. */
public final class FakeHardware implements RobotHardware {
    public int braked;
    public double left;
    public double right;
    public double base = 0.258;
    public double radius = 0.036;
    /** Rotation of the wheels in addition to that of {@link #path} and {@link #turned}. */
    public double leftAngle;
    public double rightAngle;
    public double load;
    public double path;
    public double turned;
    public boolean bumpLeft;
    public boolean bumpRight;
    public boolean dropLeft;
    public boolean dropRight;
    public boolean dropFront;
    public boolean virtualWall;
    /** Distance to the floor below the front half of the body. */
    public double floorAhead = 0.05;
    /** Distance from the middle to the surroundings. */
    public double around = Double.POSITIVE_INFINITY;

    @Override
    public void setWheelSpeeds(double newLeft, double newRight) {
        left = newLeft;
        right = newRight;
    }

    @Override
    public MotorHardware getMotor(String name) {
        return null;
    }

    @Override
    public LightHardware getLight(String name) {
        return null;
    }

    @Override
    public ServoHardware getServo(String name) {
        return null;
    }

    @Override
    public double getTrack() {
        return base;
    }

    @Override
    public double getLeftWheelAngle() {
        return leftAngle + (path - turned * base / 2) / radius;
    }

    @Override
    public double getRightWheelAngle() {
        return rightAngle + (path + turned * base / 2) / radius;
    }

    @Override
    public double getWheelRadius() {
        return radius;
    }

    @Override
    public double getLeftLoad() {
        return load;
    }

    @Override
    public double getRightLoad() {
        return load;
    }

    @Override
    public double getPath() {
        return path;
    }

    @Override
    public double getSpeed() {
        return (left + right) / 2;
    }

    @Override
    public double getTurned() {
        return turned;
    }

    @Override
    public boolean isBumpedLeft() {
        return bumpLeft;
    }

    @Override
    public boolean isBumpedRight() {
        return bumpRight;
    }

    @Override
    public boolean isLeftWheelDropped() {
        return dropLeft;
    }

    @Override
    public boolean isRightWheelDropped() {
        return dropRight;
    }

    @Override
    public boolean isCasterDropped() {
        return dropFront;
    }

    @Override
    public double look(double x, double y, double z, double dx, double dy, double dz, double range) {
        double distance = dy < 0 ? (z > 0.01 ? floorAhead : 0.05) : around;
        return distance <= range ? distance : Double.POSITIVE_INFINITY;
    }

    @Override
    public void brake() {
        braked++;
    }

    @Override
    public double getFrontAxle() {
        return 0.13;
    }

    @Override
    public double getBodyRadius() {
        return 0.165;
    }

    @Override
    public boolean isInVirtualWall() {
        return virtualWall;
    }
}
