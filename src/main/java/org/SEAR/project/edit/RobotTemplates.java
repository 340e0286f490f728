package org.SEAR.project.edit;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.ObjectStore;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.problems.ProjectException;

/** The robots that {@link Robots} makes, without their files. Any thread. */
public final class RobotTemplates {
    private static final Map<String, Function<String, SEARrobot>> ALL = new LinkedHashMap<>();

    static {
        ALL.put("roomba400", Robots::roomba400);
        ALL.put("create", Robots::create);
        ALL.put("create2", Robots::create2);
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
     * @throws ProjectException that says which there are
     */
    static SEARrobot make(String template, String name) throws ProjectException {
        Function<String, SEARrobot> maker = ALL.get(template);
        if (maker == null) {
            throw Request.refused("template", template, String.join(", ", ALL.keySet()));
        }
        return Assembly.keptBy(new NoStore(), () -> maker.apply(name));
    }

    /** Keeps nothing: what is made is written later, with what else the edit changes. */
    private static final class NoStore implements ObjectStore {
        @Override
        public void write(SearObject object, boolean part) {
            // the edit writes it
        }

        @Override
        public boolean replaces(String name) {
            return false;
        }

        @Override
        public void remove(String file, boolean part) {
            // there is none
        }

        @Override
        public void removeOwn(SearObject part) {
            // there is none
        }

        @Override
        public Integer orderOfRobot(String name) {
            return null;
        }

        @Override
        public Beam beam(String name) {
            throw new IllegalArgumentException("there are no beams here");
        }

        @Override
        public List<String> beamNames() {
            return List.of();
        }
    }
}
