// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.SEAR.POJOs.Draft;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.problems.ProjectException;

/** The robots of {@link Robots}, created without files. Any thread. */
public final class RobotTemplates {
    private static final Map<String, Function<String, SEARrobot>> ALL = new LinkedHashMap<>();

    static {
        ALL.put("roomba400", Robots::roomba400);
        ALL.put("create", Robots::create);
        ALL.put("create2", Robots::create2);
        ALL.put("rover", Robots::rover);
        ALL.put("fourWheeled", Robots::fourWheeled);
        ALL.put("car", Robots::car);
        ALL.put("chassis", Robots::chassis);
    }

    private RobotTemplates() {
    }

    /** Returns the template names, which are the names of the calls of {@link Robots}. */
    public static List<String> names() {
        return List.copyOf(ALL.keySet());
    }

    /**
     * Creates a robot with its parts.
     *
     * @param taken names in the project other than those of robots' parts
     * @throws ProjectException with the names of the templates
     */
    static SEARrobot make(String template, String name, Collection<String> taken) throws ProjectException {
        Function<String, SEARrobot> maker = ALL.get(template);
        if (maker == null) {
            throw EditRequest.refused("template", template, String.join(", ", ALL.keySet()));
        }
        return Draft.robot(taken, () -> maker.apply(name));
    }
}
