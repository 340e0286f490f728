// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;

/** Pose of an object of the grammar. Any thread. */
public final class ObjectPose {
    private ObjectPose() {
    }

    /**
     * Returns the pose set by {@code move} and {@code rotate}: in the world, or in the body frame for a component of a
     * robot.
     */
    public static Pose of(SearObject object) {
        return Pose.ofDegrees(object.getX(), object.getY(), object.getZ(), object.getRx(), object.getRy(),
            object.getRz());
    }
}
