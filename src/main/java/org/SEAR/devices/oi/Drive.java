// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import org.SEAR.devices.RobotHardware;

/** Wheel speeds as set by commands 137, 145 and 146. Velocities in mm/s; radius in mm, + to the left. */
final class Drive {
    static final int MAX_VELOCITY = 500;
    private static final int MAX_RADIUS = 2000;
    private static final int STRAIGHT = 0x7FFF;
    private static final int STRAIGHT_SCI = -0x8000;
    private static final int CLOCKWISE = -1;
    private static final int COUNTER_CLOCKWISE = 1;
    private static final double MAX_PWM = 255;
    private static final double MILLIMETRES = 1000;

    private final RobotHardware hardware;
    private double left;
    private double right;
    private int velocity;
    private int radius;
    private int requestedRight;
    private int requestedLeft;

    Drive(RobotHardware hardware) {
        this.hardware = hardware;
    }

    /**
     * Sets velocity and radius (command 137). Radius 8000h and 7FFFh mean straight, -1 and 1 turn in place. If a wheel
     * exceeds the maximum, both slow down in proportion.
     */
    void arc(int wantedVelocity, int wantedRadius) {
        velocity = clamp(wantedVelocity, MAX_VELOCITY);
        radius = wantedRadius;
        requestedLeft = 0;
        requestedRight = 0;
        if (wantedRadius == STRAIGHT || wantedRadius == STRAIGHT_SCI || wantedRadius == 0) {
            set(velocity, velocity);
        } else if (wantedRadius == CLOCKWISE) {
            set(velocity, -velocity);
        } else if (wantedRadius == COUNTER_CLOCKWISE) {
            set(-velocity, velocity);
        } else {
            radius = clamp(wantedRadius, MAX_RADIUS);
            double share = hardware.getTrack() * MILLIMETRES / 2 / radius;
            double slow = Math.min(1, MAX_VELOCITY / (Math.abs(velocity) * (1 + Math.abs(share)) + 1e-9));
            set(velocity * (1 - share) * slow, velocity * (1 + share) * slow);
        }
    }

    /** Sets both wheel velocities (command 145). */
    void direct(int wantedRight, int wantedLeft) {
        velocity = 0;
        radius = 0;
        requestedRight = clamp(wantedRight, MAX_VELOCITY);
        requestedLeft = clamp(wantedLeft, MAX_VELOCITY);
        set(requestedLeft, requestedRight);
    }

    /** Sets both wheels as shares of the battery's voltage, -255 to 255 (command 146). */
    void pwm(int wantedRight, int wantedLeft) {
        velocity = 0;
        radius = 0;
        requestedRight = 0;
        requestedLeft = 0;
        set(clamp(wantedLeft, (int) MAX_PWM) / MAX_PWM * MAX_VELOCITY, clamp(wantedRight, (int) MAX_PWM) / MAX_PWM
            * MAX_VELOCITY);
    }

    void stop() {
        direct(0, 0);
    }

    /** Stops in an emergency, without a ramp. */
    void brake() {
        stop();
        hardware.brake();
    }

    private void set(double newLeft, double newRight) {
        left = newLeft;
        right = newRight;
        hardware.setWheelSpeeds(left / MILLIMETRES, right / MILLIMETRES);
    }

    boolean isForward() {
        return left + right > 0;
    }

    /** Whether the robot drives backwards around a centre below its own body. */
    boolean isBackwardAndTight() {
        double sum = left + right;
        double turn = Math.abs(right - left);
        return sum < 0 && hardware.getTrack() / 2 * -sum < turn * hardware.getBodyRadius();
    }

    boolean isMoving() {
        return left != 0 || right != 0;
    }

    int getVelocity() {
        return velocity;
    }

    int getRadius() {
        return radius;
    }

    int getRequestedRight() {
        return requestedRight;
    }

    int getRequestedLeft() {
        return requestedLeft;
    }

    private static int clamp(int value, int limit) {
        return Math.max(-limit, Math.min(limit, value));
    }
}
