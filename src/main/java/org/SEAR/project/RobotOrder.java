package org.SEAR.project;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.project.xml.Xml;

/** Gives robots their place in the order in which they are made. Any thread. */
final class RobotOrder {
    /** The place of a robot that has no number. */
    private static final int FIRST = 1;
    private static final byte[] ROOT = ("<" + SEARrobot.class.getSimpleName()).getBytes(StandardCharsets.UTF_8);
    /** The root element is within so many bytes: behind the header and, at most, a comment. */
    private static final int HEAD = 1000;

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
        Path robots = project.resolve(ProjectFolder.ROBOT);
        int present = 0;
        int others = 0;
        if (Files.isDirectory(robots)) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(robots, "*" + ProjectFolder.XML)) {
                for (Path file : files) {
                    int place = place(file);
                    if (file.getFileName().toString().equals(name + ProjectFolder.XML)) {
                        present = place;
                    } else {
                        others = Math.max(others, place);
                    }
                }
            } catch (DirectoryIteratorException | IOException e) {
                throw new UncheckedIOException(robots + " can't be read: " + e.getMessage(), e instanceof IOException ? (IOException) e
                    : ((DirectoryIteratorException) e).getCause());
            }
        }
        last = present > last ? present : others + 1;
        return last == FIRST ? null : Integer.valueOf(last);
    }

    /** The place of the robot in a file; 0 if none can be read from it. */
    private static int place(Path file) throws IOException {
        if (!Files.isRegularFile(file) || Files.size(file) > Xml.MAX_BYTES) {
            return 0;
        }
        byte[] bytes = Files.readAllBytes(file);
        if (!startsAsRobot(bytes)) {
            return 0;
        }
        ParsedObject parsed = Xml.parse(bytes, file.toString(), Map.of(SEARrobot.class.getSimpleName(), SEARrobot.class), new ProblemList());
        if (parsed == null || parsed.isBroken()) {
            return 0;
        }
        Integer order = ((SEARrobot) parsed.object).getOrder();
        return order == null ? FIRST : order;
    }

    private static boolean startsAsRobot(byte[] bytes) {
        for (int i = 0; i < Math.min(HEAD, bytes.length - ROOT.length); i++) {
            if (Arrays.equals(bytes, i, i + ROOT.length, ROOT, 0, ROOT.length)) {
                return true;
            }
        }
        return false;
    }
}
