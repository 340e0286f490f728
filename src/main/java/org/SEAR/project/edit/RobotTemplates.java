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

/** The robots that {@link Robots} makes, without their files. Any thread. */
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

    /** Their names, as those of the calls of {@link Robots}. */
    public static List<String> names() {
        return List.copyOf(ALL.keySet());
    }

    /**
     * A new robot with its parts.
     *
     * @param taken names of what the project has besides parts of robots
     * @throws ProjectException that says which there are
     */
    static SEARrobot make(String template, String name, Collection<String> taken) throws ProjectException {
        Function<String, SEARrobot> maker = ALL.get(template);
        if (maker == null) {
            throw EditRequest.refused("template", template, String.join(", ", ALL.keySet()));
        }
        return Draft.robot(taken, () -> maker.apply(name));
    }
}
