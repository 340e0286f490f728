package org.SEAR.project;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import org.SEAR.POJOs.SEARrobot;

/** Gives robots their place in the order in which they are made. Any thread. */
final class RobotOrder {
    /** The place of a robot that has no number. */
    private static final int FIRST = 1;

    private Path folder;
    /** Place of the robot that this program made last in the folder; 0 for none. */
    private int last;

    /**
     * The place of a robot that is made now.
     *
     * @return null for the first one of the folder
     */
    synchronized Integer next(Path project, String name) {
        if (!project.equals(folder)) {
            folder = project;
            last = 0;
        }
        int present = 0;
        int others = 0;
        try {
            for (Path file : FiledRobots.files(project)) {
                int place = place(file);
                if (file.getFileName().toString().equals(name + ProjectFolder.XML)) {
                    present = place;
                } else {
                    others = Math.max(others, place);
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(project.resolve(ProjectFolder.ROBOT) + " can't be read: " + e.getMessage(), e);
        }
        last = present > last ? present : others + 1;
        return last == FIRST ? null : Integer.valueOf(last);
    }

    /** The place of the robot in a file; 0 if none can be read from it. */
    private static int place(Path file) throws IOException {
        SEARrobot robot = FiledRobots.read(file);
        Integer order = robot == null ? Integer.valueOf(0) : robot.getOrder();
        return order == null ? FIRST : order;
    }
}
