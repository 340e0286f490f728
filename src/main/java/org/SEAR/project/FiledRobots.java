// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.project.xml.Xml;

/**
 * Robots of a project as read from their files, which may come from an opened project or an earlier run. Assigns new
 * robots their position in the order of creation. Any thread.
 */
final class FiledRobots {
    private static final byte[] ROOT = ("<" + SEARrobot.class.getSimpleName()).getBytes(StandardCharsets.UTF_8);
    /** The root element starts within this number of bytes, after the header and at most a comment. */
    private static final int HEAD = 1000;

    /** Position of a robot without a number. */
    private static final int FIRST = 1;

    private FiledRobots() {
    }

    /** A change of a file. */
    interface Writer {
        /** @param bytes null to remove the file */
        void write(Path file, byte[] bytes) throws IOException;
    }

    /** Returns the files in {@code robot/} of a project, unordered. */
    static List<Path> files(Path project) throws IOException {
        List<Path> all = new ArrayList<>();
        Path folder = project.resolve(ProjectFolder.ROBOT);
        if (Files.isDirectory(folder)) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + ProjectFolder.XML)) {
                files.forEach(all::add);
            } catch (DirectoryIteratorException e) {
                throw e.getCause();
            }
        }
        return all;
    }

    /** Reads the robot of a file; null if the file contains no valid robot. */
    static SEARrobot read(Path file) throws IOException {
        if (!Files.isRegularFile(file) || Files.size(file) > Xml.MAX_BYTES) {
            return null;
        }
        byte[] bytes = Files.readAllBytes(file);
        if (!startsAsRobot(bytes)) {
            return null;
        }
        ParsedObject parsed = Xml.parse(bytes, file.toString(),
            Map.of(SEARrobot.class.getSimpleName(), SEARrobot.class), new ProblemList());
        return parsed == null || parsed.isBroken() ? null : (SEARrobot) parsed.object;
    }

    private static boolean startsAsRobot(byte[] bytes) {
        for (int i = 0; i < Math.min(HEAD, bytes.length - ROOT.length); i++) {
            if (Arrays.equals(bytes, i, i + ROOT.length, ROOT, 0, ROOT.length)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Returns the position of a new robot: that of the robot whose file it replaces, otherwise behind all others.
     *
     * @return null for the first robot of the folder
     */
    static Integer nextPlace(Path project, String name) {
        int others = 0;
        try {
            for (Path file : files(project)) {
                int place = place(file);
                if (place > 0 && file.getFileName().toString().equals(name + ProjectFolder.XML)) {
                    return place == FIRST ? null : Integer.valueOf(place);
                }
                others = Math.max(others, place);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(project.resolve(ProjectFolder.ROBOT) + " can't be read: "
                + e.getMessage(), e);
        }
        return others == 0 ? null : Integer.valueOf(others + 1);
    }

    /** Returns the position of the robot in a file; 0 if the file contains no valid robot. */
    private static int place(Path file) throws IOException {
        SEARrobot robot = read(file);
        Integer order = robot == null ? Integer.valueOf(0) : robot.getOrder();
        return order == null ? FIRST : order;
    }

    /**
     * Frees the plain file of a name: the part that has it moves into the folder of the robot whose file names it. The
     * project is consistent after each step.
     *
     * @throws IllegalArgumentException if the names are too long for that
     */
    static void makeWay(Path project, String name, Writer writer) throws IOException {
        List<Path> files = files(project);
        if (files.stream().noneMatch(file -> file.getFileName().toString()
            .equalsIgnoreCase(name + ProjectFolder.XML))) {
            return;
        }
        for (Path file : files) {
            SEARrobot robot = read(file);
            String part = robot == null ? null : robot.getComponentNames().stream().filter(name::equalsIgnoreCase)
                .findFirst().orElse(null);
            Path plain = part == null ? null : ProjectFolder.file(project, true, part);
            if (plain != null && Files.isRegularFile(plain)) {
                String aside = Assembly.nameAside(robot, part);
                writer.write(ProjectFolder.file(project, true, aside), Files.readAllBytes(plain));
                writer.write(file, Xml.write(robot).getBytes(StandardCharsets.UTF_8));
                writer.write(plain, null);
            }
        }
    }
}
