// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.List;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.problems.ProjectException;

/**
 * Duplicates an object: {@code object}, {@code name} (or a free one), {@code set} parameters of the copy. The copy
 * has no ports, since ports belong to one device.
 */
final class DuplicateEdit extends Edit {
    private static final List<String> PORTS = List.of("uartPort", "userPort", "export");

    @Override
    EditResult apply() throws IOException, ProjectException {
        ObjectLocation place = finder.find(request.text("object"));
        String old = place.object.getName();
        String name = newName(old, place.robot);
        SearObject copy = copy(place);
        assign(copy, "name", name);
        clearPorts(copy);
        if (copy instanceof SEARrobot) {
            assign(copy, "order", order());
            copyParts((SEARrobot) copy, name);
        }
        return finish(put(copy, place.robot, name), "duplicate " + old);
    }

    /** Returns a copy of the object. */
    private SearObject copy(ObjectLocation place) throws IOException, ProjectException {
        if (place.isWheel()) {
            SEARrobot again = (SEARrobot) draft.read(place.path);
            return again.getWheels().get(place.robot.getWheels().indexOf(place.object));
        }
        return draft.read(place.path);
    }

    private void copyParts(SEARrobot robot, String name) throws IOException, ProjectException {
        for (String file : List.copyOf(robot.getComponentNames())) {
            SearObject part = draft.read(ObjectFiles.path(true, file));
            if (part != null) {
                clearPorts(part);
                String own = name + "/" + part.getName();
                draft.write(ObjectFiles.path(true, own), part);
                components(robot).set(robot.getComponentNames().indexOf(file), own);
            }
        }
    }

    private static void clearPorts(SearObject object) {
        for (String port : PORTS) {
            if (parameter(object, port) != null) {
                assign(object, port, null);
            }
        }
    }
}
