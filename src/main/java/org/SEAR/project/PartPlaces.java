// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.xml.Xml;

/**
 * Tracks which part or robot of this program owns the file {@code robot/NAME.xml}. A new part or robot takes the file
 * over, and the former robot's part moves to {@code robot/ROBOT/NAME.xml}. The result is the same however often a
 * script runs. Remembers the last {@value #MOST} names. Any thread.
 */
final class PartPlaces {
    private static final int MOST = 10000;

    private final Map<String, SearObject> holders = new LinkedHashMap<>();
    /** Parts moved since {@link #begin}, and the owners at that time. */
    private final List<SearObject> moved = new ArrayList<>();
    private Map<String, SearObject> before = Map.of();

    /** Starts a unit of changes that {@link #putBack} can undo. */
    synchronized void begin() {
        moved.clear();
        before = new LinkedHashMap<>(holders);
    }

    /** Undoes the changes since {@link #begin}, except for the files. */
    synchronized void putBack() {
        moved.forEach(Assembly::forgetAside);
        holders.clear();
        holders.putAll(before);
    }

    /**
     * Frees the plain file for a part or robot that is about to be written there.
     *
     * @param writer changes the files of robots that this program did not create
     */
    synchronized void take(SearObject part, FiledRobots.Writer writer) throws IOException {
        SearObject holder = holders.get(key(part));
        if (holder == part) {
            return;
        }
        if (isOnRobot(holder)) {
            Assembly.moveAside(holder);
            moved.add(holder);
        } else {
            FiledRobots.makeWay(ProjectFolder.present(), part.getName(), writer);
        }
        holders.remove(key(part));
        holders.put(key(part), part);
        if (holders.size() > MOST) {
            holders.remove(holders.keySet().iterator().next());
        }
    }

    /** Returns whether this part was the last one written to the plain file of its name. */
    synchronized boolean has(SearObject part) {
        return holders.get(key(part)) == part;
    }

    /** Returns whether the part in the plain file of a name moves aside for another. */
    synchronized boolean givesWay(String name) throws IOException {
        return isOnRobot(holders.get(key(name)));
    }

    private static boolean isOnRobot(SearObject holder) throws IOException {
        SEARrobot robot = holder == null || holder instanceof Wheel ? null : Assembly.robotOf(holder);
        return robot != null && holder.getFileName().equals(holder.getName()) && isInProject(robot);
    }

    /**
     * Returns whether the current project contains the robot unchanged: it was neither created again nor has another
     * project been opened.
     */
    private static boolean isInProject(SEARrobot robot) throws IOException {
        Path file = ProjectFolder.file(ProjectFolder.present(), true, robot.getName());
        return Files.isRegularFile(file)
            && Arrays.equals(Files.readAllBytes(file), Xml.write(robot).getBytes(StandardCharsets.UTF_8));
    }

    private static String key(SearObject part) {
        return key(part.getName());
    }

    private static String key(String name) {
        return name.toLowerCase(Locale.ROOT);
    }
}
