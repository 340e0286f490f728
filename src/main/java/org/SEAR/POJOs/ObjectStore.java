package org.SEAR.POJOs;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;

/**
 * Where objects of the grammar keep themselves: the present SEARproject folder. The project room implements it; found by
 * {@link java.util.ServiceLoader}. Any thread.
 */
public interface ObjectStore {
    /**
     * Writes an object's file, whole or not at all. Another robot's part of that name, which this program made, moves its file into its robot's own
     * folder before.
     *
     * @param part whether it goes to {@code robot/} instead of {@code environment/}
     */
    void write(SearObject object, boolean part) throws IOException;

    /** Whether an object that is made now replaces one of its name: there is a file of it, in either folder, that does not make way. */
    boolean replaces(String name) throws IOException;

    /** Whether there is a file, named as for {@link #remove}. */
    boolean keeps(String file, boolean part) throws IOException;

    /**
     * Removes the file of an object if there is one.
     *
     * @param file as {@link SearObject#getFileName}
     * @param part whether it lies in {@code robot/}
     */
    void remove(String file, boolean part) throws IOException;

    /** Removes the file of a part that stands in its robot's file from now on, unless another part was written there since. */
    void removeOwn(SearObject part) throws IOException;

    /** Makes several objects that belong together: if the maker fails, the project is as it was. */
    <T> T whole(Supplier<T> maker);

    /**
     * What a part of a ready robot is called.
     *
     * @param part its plain name, which it has unless an object of the environment or a robot has it; then it is {@code robot part}
     */
    String partName(String robot, String part) throws IOException;

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
