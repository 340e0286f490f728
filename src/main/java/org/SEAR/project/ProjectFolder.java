// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Layout of a SEARproject folder. */
public final class ProjectFolder {
    public static final String ENVIRONMENT = "environment";
    public static final String ROBOT = "robot";
    public static final String ASSETS = "assets";
    public static final String BEAMS = "beams";
    public static final String XML = ".xml";

    private ProjectFolder() {
    }

    /** Returns the program's folder: SEARproject in the working folder, or the system property {@code sear.project}. */
    public static Path present() {
        return Paths.get(System.getProperty("sear.project", "SEARproject")).toAbsolutePath().normalize();
    }

    /** Returns the file of an object. */
    public static Path file(Path folder, boolean part, String name) {
        try {
            return folder.resolve(part ? ROBOT : ENVIRONMENT).resolve(name + XML);
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("name is \"" + name + "\", legal: a name that Java can encode in file "
                + "names on this system ("
                + System.getProperty("sun.jnu.encoding") + "); with LC_ALL=C.UTF-8 in the environment every "
                    + "name is legal", e);
        }
    }
}
