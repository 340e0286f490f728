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
 * Which of the parts and robots that this program made has the file {@code robot/NAME.xml} of its name. What comes after a robot's part has the
 * place, and that part moves into the folder of its robot, {@code robot/ROBOT/NAME.xml}: so the last robot's part is where a part of a name of its
 * own is, however often a script runs. Remembers the last {@value #MOST} names. Any thread.
 */
final class PartPlaces {
    private static final int MOST = 10000;

    private final Map<String, SearObject> holders = new LinkedHashMap<>();
    /** Those that moved since {@link #begin}, and who had which place then. */
    private final List<SearObject> moved = new ArrayList<>();
    private Map<String, SearObject> before = Map.of();

    /** Something that may fail halfway begins. */
    synchronized void begin() {
        moved.clear();
        before = new LinkedHashMap<>(holders);
    }

    /** It has failed: their files are where they were. */
    synchronized void putBack() {
        moved.forEach(Assembly::forgetAside);
        holders.clear();
        holders.putAll(before);
    }

    /**
     * Makes the plain place free for a part or robot that is about to be written there.
     *
     * @param writer changes the files of robots that this program did not make
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

    /** Whether this was the last to be written to the plain place of its name. */
    synchronized boolean has(SearObject part) {
        return holders.get(key(part)) == part;
    }

    /** Whether the part in the plain place of a name moves aside for another. */
    synchronized boolean givesWay(String name) throws IOException {
        return isOnRobot(holders.get(key(name)));
    }

    private static boolean isOnRobot(SearObject holder) throws IOException {
        SEARrobot robot = holder == null || holder instanceof Wheel ? null : Assembly.robotOf(holder);
        return robot != null && holder.getFileName().equals(holder.getName()) && isInProject(robot);
    }

    /** Whether the present project has the robot as it is: it was not made again, and no other project has come. */
    private static boolean isInProject(SEARrobot robot) throws IOException {
        Path file = ProjectFolder.file(ProjectFolder.present(), true, robot.getName());
        return Files.isRegularFile(file) && Arrays.equals(Files.readAllBytes(file), Xml.write(robot).getBytes(StandardCharsets.UTF_8));
    }

    private static String key(SearObject part) {
        return key(part.getName());
    }

    private static String key(String name) {
        return name.toLowerCase(Locale.ROOT);
    }
}
