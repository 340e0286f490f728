// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.List;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.problems.ProjectException;

/** Renames an object: {@code object}, {@code name}. */
final class RenameEdit extends Edit {
    @Override
    EditResult apply() throws IOException, ProjectException {
        ObjectLocation place = finder.find(request.text("object"));
        String old = place.object.getName();
        String name = request.text("name");
        if (!name.equalsIgnoreCase(old)) {
            checkName(name, place.robot);
        }
        assign(place.object, "name", name);
        if (place.isWheel()) {
            write(place);
        } else if (place.robot != null) {
            String stem = ObjectFiles.stem(place.path);
            draft.delete(place.path);
            String file = stem.contains("/") ? place.robot.getName() + "/" + name
                : finder.partFile(place.robot.getName(), name);
            components(place.robot).set(place.robot.getComponentNames().indexOf(stem), file);
            draft.write(ObjectFiles.path(true, file), place.object);
            draft.write(place.robotPath(), place.robot);
        } else {
            draft.delete(place.path);
            if (place.object instanceof SEARrobot) {
                moveOwnFolder((SEARrobot) place.object, old);
            }
            draft.write(ObjectFiles.path(place.path.startsWith(ProjectFolder.ROBOT + "/"), name), place.object);
        }
        if (place.robot != null) {
            new References(draft, place.robot).follow(place.object, old);
        } else {
            JointReferences.follow(draft, old, name);
        }
        return new EditResult("rename " + old + " to " + name, place.address(), List.of());
    }

    /** Moves the parts in a robot's own folder when the robot is renamed. */
    private void moveOwnFolder(SEARrobot robot, String old) throws IOException, ProjectException {
        for (String file : List.copyOf(robot.getComponentNames())) {
            if (file.startsWith(old + "/")) {
                String moved = robot.getName() + file.substring(old.length());
                SearObject part = draft.read(ObjectFiles.path(true, file));
                if (part != null) {
                    draft.write(ObjectFiles.path(true, moved), part);
                    draft.delete(ObjectFiles.path(true, file));
                }
                components(robot).set(robot.getComponentNames().indexOf(file), moved);
            }
        }
    }
}
