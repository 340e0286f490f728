// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A pupil's script for a lesson. Immutable. */
final class Submission {
    private static final String ENDING = ".py";

    final String pupil;
    final Lesson lesson;
    /** Null if there is none. */
    final Path script;

    private Submission(String pupil, Lesson lesson, Path script) {
        this.pupil = pupil;
        this.lesson = lesson;
        this.script = script;
    }

    /**
     * Finds all scripts to mark.
     *
     * @param path a script; or a folder with scripts, or with folders, each named after its pupil
     * @param lesson null if each script is named after its lesson
     * @throws IOException if there is nothing to mark
     */
    static List<Submission> in(Path path, Lesson lesson) throws IOException {
        List<Submission> all = new ArrayList<>();
        if (Files.isRegularFile(path)) {
            if (lesson == null && !Lesson.isKnown(stem(path))) {
                throw new IOException(path + " is not named after a lesson, legal: " + Lesson.names()
                    + "; or name the lesson: sear grade --lesson NAME " + path);
            }
            all.add(new Submission(stem(path), lesson == null ? Lesson.find(stem(path)) : lesson, path));
        } else if (Files.isDirectory(path)) {
            boolean isOfPupil = Files.isDirectory(path.resolve("SEARproject"));
            for (Path entry : list(path)) {
                if (Files.isDirectory(entry) && !isOfPupil && !entry.getFileName().toString().startsWith(".")) {
                    all.addAll(ofPupil(entry, lesson));
                } else if (isScript(entry)) {
                    all.addAll(ofFile(entry, lesson, isOfPupil));
                }
            }
        } else {
            throw new IOException("there is no script or folder " + path);
        }
        if (all.isEmpty()) {
            throw new IOException(path + " has nothing to mark: it needs scripts, or folders with scripts"
                + (lesson == null ? ", named after their lesson, as square.py; or give --lesson NAME" : ""));
        }
        return all;
    }

    private static List<Submission> ofFile(Path script, Lesson lesson, boolean isOfPupil) throws IOException {
        if (lesson == null) {
            return Lesson.isKnown(stem(script))
                ? List.of(new Submission(stem(script), Lesson.find(stem(script)), script)) : List.of();
        }
        return isOfPupil && !stem(script).equals(lesson.getName()) ? List.of()
            : List.of(new Submission(stem(script), lesson, script));
    }

    /** Finds the scripts in a pupil's folder. */
    private static List<Submission> ofPupil(Path folder, Lesson lesson) throws IOException {
        String pupil = folder.getFileName().toString();
        List<Path> scripts = list(folder).stream().filter(Submission::isScript).collect(Collectors.toList());
        List<Submission> found = new ArrayList<>();
        if (lesson == null) {
            for (Path script : scripts) {
                if (Lesson.isKnown(stem(script))) {
                    found.add(new Submission(pupil, Lesson.find(stem(script)), script));
                }
            }
            return found;
        }
        Path named = scripts.stream().filter(one -> stem(one).equals(lesson.getName())).findFirst()
            .orElse(scripts.size() == 1 ? scripts.get(0) : null);
        return pupil.startsWith("SEARproject") ? List.of() : List.of(new Submission(pupil, lesson, named));
    }

    private static boolean isScript(Path file) {
        return Files.isRegularFile(file) && file.getFileName().toString().endsWith(ENDING);
    }

    private static String stem(Path file) {
        String name = file.getFileName().toString();
        return name.endsWith(ENDING) ? name.substring(0, name.length() - ENDING.length()) : name;
    }

    private static List<Path> list(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.sorted().collect(Collectors.toList());
        }
    }
}
