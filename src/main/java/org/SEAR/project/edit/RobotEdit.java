// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.problems.ProjectException;

/** Adds a ready robot: {@code template}, {@code name} (or a free one), {@code set} parameters of the robot. */
final class RobotEdit extends Edit {
    @Override
    EditResult apply() throws IOException, ProjectException {
        String template = request.text("template");
        String name = newName(template, null);
        SEARrobot robot = RobotTemplates.make(template, name, finder.wholes(name));
        assign(robot, "order", order());
        for (SearObject part : robot.getComponents()) {
            String file = finder.partFile(name, part.getName());
            components(robot).set(robot.getComponentNames().indexOf(part.getName()), file);
            draft.write(ObjectFiles.path(true, file), part);
        }
        return finish(put(robot, null, name), "add " + name);
    }
}
