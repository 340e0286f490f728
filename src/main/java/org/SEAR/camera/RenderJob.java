package org.SEAR.camera;

import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;

/** What there is to be seen, and from where. Nobody moves anything in the scene while a picture of it is made. */
public final class RenderJob {
    final BeamScene scene;
    final Appearances looks;
    final Pose eye;
    final int ignoredOwner;

    /**
     * @param eye x to the left, y up, z ahead
     * @param ignoredOwner the robot that is not seen; {@link BeamScene#WORLD} for none
     */
    public RenderJob(BeamScene scene, Appearances looks, Pose eye, int ignoredOwner) {
        this.scene = scene;
        this.looks = looks;
        this.eye = eye;
        this.ignoredOwner = ignoredOwner;
    }
}
