// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.files.AtomicFile;
import org.SEAR.project.Project;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.PercentProgress;
import org.SEAR.project.problems.ProjectException;

/**
 * A lesson: a folder NAME with the page README.md, pictures, the world world.sear, the initial script NAME.py, and
 * check.py. Immutable, any thread.
 */
final class Lesson {
    private static final String PAGE = "README.md";
    private static final String WORLD = "world.sear";
    private static final String CHECK = "check.py";
    private static final String PROJECT = "SEARproject";

    private final Path folder;

    private Lesson(Path folder) {
        this.folder = folder;
    }

    /** Returns SEAR's own lessons, by name. */
    static List<Lesson> all() throws IOException {
        Path home = home();
        if (!Files.isDirectory(home)) {
            return List.of();
        }
        try (Stream<Path> folders = Files.list(home)) {
            return folders.filter(one -> Files.exists(one.resolve(CHECK))).sorted().map(Lesson::new)
                .collect(Collectors.toList());
        }
    }

    private static Path home() {
        return Path.of(System.getProperty("sear.home", ".")).resolve("lessons").toAbsolutePath().normalize();
    }

    /**
     * Finds one of SEAR's lessons or a teacher's own.
     *
     * @param nameOrFolder its name or its folder
     * @throws IOException if there is no such lesson, or its folder is incomplete
     */
    static Lesson find(String nameOrFolder) throws IOException {
        Path given = Path.of(nameOrFolder).toAbsolutePath().normalize();
        Path own = home().resolve(nameOrFolder).normalize();
        boolean named = nameOrFolder.matches("[\\w-]+") && Files.exists(own.resolve(CHECK));
        Lesson lesson = new Lesson(named ? own : given);
        if (!named && !Files.isDirectory(given)) {
            throw new IOException("there is no lesson \"" + nameOrFolder + "\", legal: " + names()
                + ", or the folder of a lesson of your own");
        }
        List<String> missing = new ArrayList<>();
        for (Path part : List.of(lesson.check(), lesson.world(), lesson.script())) {
            if (!Files.isRegularFile(part)) {
                missing.add(part.getFileName().toString());
            }
        }
        if (!missing.isEmpty()) {
            throw new IOException(lesson.folder + " is not a lesson: it lacks " + String.join(", ", missing));
        }
        return lesson;
    }

    /** Returns whether SEAR has a lesson of that name. */
    static boolean isKnown(String name) throws IOException {
        return all().stream().anyMatch(one -> one.getName().equals(name));
    }

    /** Returns the names of SEAR's lessons, in a line. */
    static String names() throws IOException {
        return all().stream().map(Lesson::getName).collect(Collectors.joining(", "));
    }

    String getName() {
        return folder.getFileName().toString();
    }

    Path check() {
        return folder.resolve(CHECK);
    }

    Path world() {
        return folder.resolve(WORLD);
    }

    /** Returns the initial script. */
    Path script() {
        return folder.resolve(getName() + ".py");
    }

    /** Returns the heading of the lesson's page; empty if it has none. */
    String title() throws IOException {
        Path page = folder.resolve(PAGE);
        if (!Files.exists(page)) {
            return "";
        }
        try (Stream<String> lines = Files.lines(page)) {
            return lines.filter(line -> line.startsWith("# ")).map(line -> line.substring(2).trim()).findFirst()
                .orElse("");
        }
    }

    /** Unpacks the lesson's world as the project of a folder. */
    Project unpack(Path to) throws IOException, ProjectException {
        Files.createDirectories(to);
        return Bundle.load(world(), to.resolve(PROJECT), new PercentProgress("opening", world(), line -> { }));
    }

    /**
     * Copies page, pictures, world and script to a folder.
     *
     * @throws IOException if the folder has a script of that name, which may be the pupil's
     */
    void handOut(Path to) throws IOException, ProjectException {
        Path script = to.resolve(script().getFileName());
        if (Files.exists(script)) {
            throw new IOException(script + " exists already and was not changed: choose another folder, or "
                + "move the file");
        }
        unpack(to);
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : (Iterable<Path>) files.filter(Lesson::isForPupils)::iterator) {
                AtomicFile.write(to.resolve(file.getFileName()),
                    place -> Files.copy(file, place, StandardCopyOption.REPLACE_EXISTING));
            }
        }
        AtomicFile.write(script, place -> Files.copy(script(), place, StandardCopyOption.REPLACE_EXISTING));
    }

    private static boolean isForPupils(Path file) {
        String name = file.getFileName().toString();
        return Files.isRegularFile(file) && !name.endsWith(".py") && !name.equals(WORLD);
    }
}
