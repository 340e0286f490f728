// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import org.SEAR.project.problems.ProjectException;

/** Unmounts a shape: {@code object}, {@code set} parameters in the world frame. */
final class UnmountEdit extends Edit {
    @Override
    EditResult apply() throws IOException, ProjectException {
        ObjectLocation place = finder.find(request.text("object"));
        if (place.robot == null) {
            throw EditRequest.refused("object", place.address(), "a part of a robot");
        }
        if (!Grammar.standsInEnvironment(place.object.getClass())) {
            throw EditRequest.refused("object", place.address(), "a shape: a " + place.object.getClass().getSimpleName()
                + " can't stand in the world without a robot; mount it on another one, or delete it");
        }
        return move(place, null, "take " + place.object.getName() + " off " + place.robot.getName());
    }
}
