// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.problems.ProjectException;

/** Adds an object: {@code type}, {@code name} (or a free one), {@code to} a robot, {@code set} parameters. */
final class AddEdit extends Edit {
    @Override
    EditResult apply() throws IOException, ProjectException {
        String type = request.text("type");
        Class<? extends SearObject> found = draft.classes().get(type);
        if (found == null) {
            throw EditRequest.refused("type", type, String.join(", ", draft.classes().keySet()));
        }
        String to = request.textOrNull("to");
        if (to == null && !Grammar.standsInEnvironment(found) && found != SEARrobot.class) {
            throw EditRequest.refused("to", "", "the name of a robot: a " + type + " is a part of one");
        }
        if (to != null && !Grammar.standsOnRobot(found)) {
            throw EditRequest.refused("to", to, "nothing: a " + type + " can't be a part of a robot");
        }
        SEARrobot robot = to == null ? null : finder.robot(to);
        String name = newName(defaultName(type), robot);
        SearObject object = (SearObject) ParameterTable.of(found).newInstance();
        Map<String, Object> initial = new HashMap<>();
        for (Parameter parameter : ParameterTable.of(found).getParameters()) {
            if (!parameter.getInitial().isEmpty()) {
                initial.put(parameter.getName(), parameter.isList() ? List.of(parameter.getInitial().split("\n"))
                    : parameter.getInitial());
            }
        }
        assign(object, "name", name);
        if (object instanceof SEARrobot) {
            assign(object, "order", order());
        }
        ObjectLocation place = put(object, robot, name);
        set(place.path, object, initial, Map.of());
        return finish(place, "add " + name);
    }

    /** Returns the default name of a class: box, lidar, robot. */
    private static String defaultName(String type) {
        String plain = type.startsWith("SEAR") ? type.substring(4) : type;
        boolean capitals = plain.equals(plain.toUpperCase(Locale.ROOT));
        return capitals ? plain.toLowerCase(Locale.ROOT) : Character.toLowerCase(plain.charAt(0)) + plain.substring(1);
    }
}
