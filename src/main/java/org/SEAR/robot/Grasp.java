// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import org.SEAR.physics.Body;

/** Loose objects that touch two parts of a robot in one step, as a gripper's object does. Simulation thread. */
final class Grasp {
    private static final int MOST = 8;

    private final Body[] objects = new Body[MOST];
    private final int[] parts = new int[MOST];
    private int count;
    private boolean holds;

    void clear() {
        count = 0;
        holds = false;
    }

    /** Notes that a part touches an object. */
    void touched(int part, Body other) {
        if (other.isFixed() || other.isRobot()) {
            return;
        }
        for (int i = 0; i < count; i++) {
            if (objects[i] == other) {
                holds |= parts[i] != part;
                return;
            }
        }
        if (count < MOST) {
            objects[count] = other;
            parts[count++] = part;
        }
    }

    /** Whether the robot holds an object between two parts. */
    boolean holds() {
        return holds;
    }
}
