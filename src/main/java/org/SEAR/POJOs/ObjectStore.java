package org.SEAR.POJOs;

import java.io.IOException;
import java.util.List;

/**
 * Where objects of the grammar keep themselves: the present SEARproject folder. The project room implements it; found by
 * {@link java.util.ServiceLoader}. Any thread.
 */
public interface ObjectStore {
    /**
     * Writes an object's file, whole or not at all.
     *
     * @param part whether it goes to {@code robot/} instead of {@code environment/}
     */
    void write(SearObject object, boolean part) throws IOException;

    /** Whether there is the file of an object of that name, in either folder. */
    boolean has(String name);

    /**
     * Removes the file of an object if there is one.
     *
     * @param part whether it lies in {@code robot/}
     */
    void remove(String name, boolean part) throws IOException;

    /**
     * The place of a robot that is made now in the order of the project's robots: behind all others. One that is made again keeps its place as long
     * as this program has made none before it that stands behind.
     *
     * @return null for the first robot of a project
     */
    Integer orderOfRobot(String name);

    /**
     * A named beam: one of the project's own ({@code beams/} of the folder), or a built-in one.
     *
     * @throws IllegalArgumentException that names the beams there are
     */
    Beam beam(String name);

    /** Names of all beams, the project's own included, in order. */
    List<String> beamNames();
}
