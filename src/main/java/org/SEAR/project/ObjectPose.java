package org.SEAR.project;

import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;

/** Where an object of the grammar stands. Any thread. */
public final class ObjectPose {
    private ObjectPose() {
    }

    /** The pose that {@code move} and {@code rotate} have given it: in the world, or in its robot's body frame once it is a component. */
    public static Pose of(SearObject object) {
        return Pose.ofDegrees(object.getX(), object.getY(), object.getZ(), object.getRx(), object.getRy(), object.getRz());
    }
}
