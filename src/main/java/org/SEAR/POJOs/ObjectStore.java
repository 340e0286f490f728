// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;

/**
 * Storage of the objects of the grammar: the current SEARproject folder. {@link java.util.ServiceLoader} finds the
 * implementation, in {@code org.SEAR.project}. Any thread.
 */
public interface ObjectStore {
    /**
     * Writes an object's file, completely or not at all. If the file belongs to another robot's part of this program,
     * that part's file first moves into its robot's own folder.
     *
     * @param part whether the file goes to {@code robot/} instead of {@code environment/}
     */
    void write(SearObject object, boolean part) throws IOException;

    /**
     * Returns whether a new object of this name would replace one: either folder has a file of that name that does not
     * move aside.
     */
    boolean replaces(String name) throws IOException;

    /** Returns whether a file exists; the parameters are those of {@link #remove}. */
    boolean keeps(String file, boolean part) throws IOException;

    /**
     * Removes the file of an object if it exists.
     *
     * @param file as {@link SearObject#getFileName}
     * @param part whether the file lies in {@code robot/}
     */
    void remove(String file, boolean part) throws IOException;

    /**
     * Removes the file of a part that its robot's file now contains, unless the file has been overwritten by another
     * part.
     */
    void removeOwn(SearObject part) throws IOException;

    /** Creates several objects as a unit: if the maker fails, the project is restored. */
    <T> T whole(Supplier<T> maker);

    /**
     * Returns the name of a part of a ready robot.
     *
     * @param part its plain name; if an object of the environment or a robot has that name, the result is
     *     {@code robot part}
     */
    String partName(String robot, String part) throws IOException;

    /**
     * Returns the position of a new robot in the order of the project's robots: the last. A robot that is created again
     * keeps its position, unless this program has before created a robot that comes later in the order.
     *
     * @return null for the first robot of a project
     */
    Integer orderOfRobot(String name);

    /**
     * Returns a named beam of the project ({@code beams/} of the folder), or a built-in one.
     *
     * @throws IllegalArgumentException with the names of the beams
     */
    Beam beam(String name);

    /** Returns the names of all beams, including the project's, in order. */
    List<String> beamNames();
}
