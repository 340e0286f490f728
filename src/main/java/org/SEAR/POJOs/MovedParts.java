// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;

/** Checks the components that a servo or joint moves besides its own. */
final class MovedParts {
    /** Components that servos and joints can move, in words. */
    static final String LEGAL = "a shape, a light, a servo, or a sensor except motion sensors and GPS";
    static final int MOST = 100;

    private MovedParts() {
    }

    /** Returns whether a servo or joint can move a component: not a wheel, nor a sensor of motion or position. */
    static boolean canMove(SearObject part) {
        boolean still = part instanceof Accelerometer || part instanceof Gyroscope || part instanceof IMU
            || part instanceof GPS
            || part instanceof Odometer || part instanceof Wheel;
        return !still && (part instanceof Shape || part instanceof SensorObject || part instanceof Servo
            || part instanceof Led);
    }

    /**
     * Adds a part.
     *
     * @param names of the parts that the servo or joint moves
     * @throws IllegalArgumentException if the part can't be moved, something else moves it, or it is on another robot
     */
    static void add(SearObject mover, List<String> names, SearObject part) {
        String label = mover.label();
        if (part == null || !canMove(part) || part == mover) {
            throw new IllegalArgumentException(
                label + ": " + (part == null ? "part is missing (None)" : part.label() + " can't be mounted")
                + ", legal: " + LEGAL);
        }
        if (part.getMover() != null) {
            throw new IllegalArgumentException(label + ": " + part.label() + " is mounted on "
                + part.getMover().label()
                + ", legal: a part that no servo or joint moves yet");
        }
        for (SearObject one = mover; one != null; one = one.getMover()) {
            if (one == part) {
                throw new IllegalArgumentException(label + ": " + part.label() + " turns it, legal: a part that "
                    + "does not turn it");
            }
        }
        if (mover.robot() != null && part.robot() != null && mover.robot() != part.robot()) {
            throw new IllegalArgumentException(label + ": " + part.label() + " is a part of " + part.robot().label()
                + ", legal: a part of "
                + mover.robot().label());
        }
        if (names.size() >= MOST) {
            throw new IllegalArgumentException(label + ": part is " + part.label() + ", legal: at most " + MOST
                + " parts");
        }
        names.add(part.getName());
        part.setMover(mover);
    }
}
