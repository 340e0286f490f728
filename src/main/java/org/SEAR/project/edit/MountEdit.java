// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.Map;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.project.problems.ProjectException;

/** Mounts an object: {@code object}, {@code to} a robot, {@code set} parameters in the robot's frame. */
final class MountEdit extends Edit {
    @Override
    EditResult apply() throws IOException, ProjectException {
        ObjectLocation place = finder.find(request.text("object"));
        String to = request.text("to");
        if (!Grammar.standsOnRobot(place.object.getClass())) {
            throw EditRequest.refused("to", to, "nothing: a " + place.object.getClass().getSimpleName()
                + " can't be a part of a robot");
        }
        if (place.object instanceof PlacedObject) {
            standWherePut(place.object, Map.of("y", ""));
        }
        return move(place, to, "mount " + place.object.getName() + " on " + to);
    }
}
