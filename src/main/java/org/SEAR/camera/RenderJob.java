// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;

/** Scene and viewpoint of a picture. The scene must not move while a picture is rendered. */
public final class RenderJob {
    final BeamScene scene;
    final Appearances looks;
    final Pose eye;
    final int ignoredOwner;

    /**
     * @param eye pose of the camera: x to the left, y up, z ahead
     * @param ignoredOwner invisible robot; {@link BeamScene#WORLD} for none
     */
    public RenderJob(BeamScene scene, Appearances looks, Pose eye, int ignoredOwner) {
        this.scene = scene;
        this.looks = looks;
        this.eye = eye;
        this.ignoredOwner = ignoredOwner;
    }
}
