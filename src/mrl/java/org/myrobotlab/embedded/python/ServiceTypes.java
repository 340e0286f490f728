// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.myrobotlab.embedded.NearestName;
import org.myrobotlab.framework.Service;

/** The service types of this MyRobotLab and those that only the real one has. Any thread. */
public final class ServiceTypes {
    private static final String PACKAGE = "org.myrobotlab.service";
    /** The types of MyRobotLab 1.1.1558 that the embedded one lacks, one per line. */
    private static final String OTHERS = "/org/myrobotlab/embedded/real-services.txt";

    private ServiceTypes() {
    }

    /** Returns the types that can be started here, sorted. */
    private static Set<String> here() {
        try {
            return PackageClasses.of(PACKAGE, ServiceTypes.class.getClassLoader()).stream()
                .filter(ServiceTypes::isService).collect(Collectors.toCollection(TreeSet::new));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static boolean isService(String name) {
        try {
            Class<?> type = Class.forName(PACKAGE + "." + name, false, ServiceTypes.class.getClassLoader());
            return Service.class.isAssignableFrom(type) && Modifier.isPublic(type.getModifiers())
                && !Modifier.isAbstract(type.getModifiers());
        } catch (ClassNotFoundException | LinkageError e) {
            return false;
        }
    }

    private static Set<String> onlyReal() {
        try (InputStream list = ServiceTypes.class.getResourceAsStream(OTHERS)) {
            return new TreeSet<>(List.of(new String(list.readAllBytes(), StandardCharsets.UTF_8).split("\\R")));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns whether the text is the name of a type, of this MyRobotLab or of the real one. */
    public static boolean isKnown(String type) {
        return here().contains(type) || onlyReal().contains(type);
    }

    /** Returns why this MyRobotLab lacks a type, and what to do: for a type of the real one, or a similar name. */
    public static String missing(String type) {
        Set<String> known = here();
        if (onlyReal().contains(type)) {
            String own = known.stream().filter(type::equalsIgnoreCase)
                .map(one -> "; did you mean SEAR's own, " + one + "?").findFirst().orElse("");
            return advice(type) + own;
        }
        known.addAll(onlyReal());
        String near = NearestName.of(type, known);
        return "there is no service type " + type
            + (near.isEmpty() ? "; the types here are " + String.join(", ", here()) : "; " + near);
    }

    /** Returns a hint for a type that only the real MyRobotLab has; empty for any other name. Python calls it. */
    public static String hint(String type) {
        return onlyReal().contains(type) ? advice(type) : "";
    }

    private static String advice(String type) {
        return "only the real MyRobotLab has the service " + type + ": install SEAR there by the command \"sear "
            + "install FOLDER\", with the"
            + " folder of its myrobotlab.jar, and run the script in its Python tab (docs/install.md)";
    }
}
