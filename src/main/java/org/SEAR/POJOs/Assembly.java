// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;
import java.util.function.Supplier;
import org.SEAR.grammar.Faults;

/** Package access for {@link org.SEAR.project}, which assembles objects that were read from files. */
public final class Assembly {
    private Assembly() {
    }

    /**
     * Adds a component that was read from its own file to the robot whose file names it.
     *
     * @param aside whether the file lies in the robot's own folder
     */
    public static void link(SEARrobot robot, SearObject component, boolean aside) {
        robot.link(component, aside);
    }

    /** Creates several objects; if the work fails, the project has none of them. */
    public static <T> T whole(Supplier<T> work) {
        return ObjectStores.get().whole(work);
    }

    /** Returns whether a new object of this name would replace one. */
    public static boolean replaces(String name) throws IOException {
        return ObjectStores.get().replaces(name);
    }

    /** Returns the robot of a part; null for an object that is not part of a robot. */
    public static SEARrobot robotOf(SearObject part) {
        return part.robot();
    }

    /**
     * Moves the file of a robot's component into the robot's own folder, see {@link SearObject#getFileName}, and writes
     * the robot's file.
     *
     * @throws IOException if a file can't be written; nothing has changed then
     * @throws IllegalArgumentException if the names are too long for a file
     */
    public static void moveAside(SearObject component) throws IOException {
        component.robot().moveAside(component);
    }

    /**
     * Changes the name of a component in a robot that was read to that of a file in the robot's own folder.
     *
     * @return the new name, {@code robot/name}
     * @throws IllegalArgumentException if the names are too long for a file
     */
    public static String nameAside(SEARrobot robot, String component) {
        return robot.nameAside(component);
    }

    /** Undoes {@link #moveAside}, except for the files. */
    public static void forgetAside(SearObject component) {
        component.robot().forgetAside(component);
    }

    /** Sets the name by which scripts address a part that was read, see {@link SearObject#getFullName}. */
    public static void setFullName(SearObject part, String fullName) {
        part.setFullName(fullName);
    }

    /** Sets the beam data of a distance sensor that was read from a file. */
    public static void link(Distance sensor, Beam beam) {
        sensor.link(beam);
    }

    /** Adds the faults of an object's combined values. */
    public static void crossCheck(SearObject object, Faults faults) {
        object.crossCheck(faults);
    }

    /** Returns whether objects of this kind are always parts of a robot, so that their files lie in {@code robot/}. */
    public static boolean isRobotPart(SearObject object) {
        return object.isRobotPart();
    }
}
