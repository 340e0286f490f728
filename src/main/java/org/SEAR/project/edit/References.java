package org.SEAR.project.edit;

import java.io.IOException;
import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.Parameter;
import org.SEAR.POJOs.ParameterTable;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;

/**
 * The names by which parts of a robot know each other: a motor its wheels, a servo what it turns, a wheel its servo, a bumper what presses it, an
 * Arduino what is wired to it. The grammar says which parameters these are. Whoever holds the project's lock.
 */
final class References {
    private References() {
    }

    /**
     * Has the names in a robot's file and in those of its parts follow a part that has another name now.
     *
     * @param robot as it is to be, with the part's new name
     * @param part with its new name
     * @param old the part's name before
     */
    static void follow(Draft draft, SEARrobot robot, SearObject part, String old) throws IOException {
        if (follow(robot, part, old)) {
            draft.write(ObjectFiles.path(true, robot.getName()), robot);
        }
        for (String file : robot.getComponentNames()) {
            String path = ObjectFiles.path(true, file);
            SearObject other = draft.readIfWhole(path);
            if (other != null && follow(other, part, old)) {
                draft.write(path, other);
            }
        }
    }

    /** @return whether the object or group has named the part */
    private static boolean follow(Object object, SearObject part, String old) {
        boolean changed = false;
        for (Parameter parameter : ParameterTable.of(object.getClass()).getParameters()) {
            List<Object> values = parameter.values(object);
            if (parameter.getKind() == Parameter.Kind.GROUP) {
                for (Object group : values) {
                    changed |= follow(group, part, old);
                }
            } else if (parameter.isNameOf(part) && Collections.replaceAll(values, old, part.getName())) {
                parameter.set(object, parameter.isList() ? values : values.get(0));
                changed = true;
            }
        }
        return changed;
    }
}
