// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.plan.Plan;
import org.SEAR.plan.PlanDrawing;
import org.SEAR.plot.DrawingFiles;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectOrigin;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.ProjectWords;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;

/** Projects that a panel can open, with pictures: bundles in the working folder, and backups. Any thread. */
final class ProjectShelf {
    /** Size above which a bundle gets no picture, bytes. */
    private static final long LARGE = 20 << 20;
    private static final int MAX_PICTURES = 64;
    private static final String ENDING = ".sear";

    private final Map<String, String> pictures = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, String> eldest) {
            return size() > MAX_PICTURES;
        }
    };

    /**
     * Returns bundles in the working folder, then the backups of a project, each newest first.
     *
     * @return {@code {"kind": "own" or "kept", "path": for loadProject, "title": name of the bundle, "words": contents
     *     of a backup, else empty, "time": of saving, milliseconds since 1970}}
     */
    synchronized List<Map<String, Object>> list(Path folder) throws IOException {
        List<Map<String, Object>> own = new ArrayList<>();
        try (DirectoryStream<Path> bundles = Files.newDirectoryStream(Paths.get(""), "*" + ENDING)) {
            for (Path bundle : bundles) {
                if (Files.isRegularFile(bundle)) {
                    own.add(entry("own", bundle.toString(), bundle, ""));
                }
            }
        }
        own.sort(Comparator.comparing((Map<String, Object> one) -> (Long) one.get("time")).reversed());
        for (Path backup : ProjectSwap.backups(folder)) {
            String words = words(backup);
            if (!words.isEmpty()) {
                own.add(entry("kept", backup.toString(), Paths.get(ProjectOrigin.of(backup).path), words));
            }
        }
        return own;
    }

    private static Map<String, Object> entry(String kind, String path, Path bundle, String words) throws IOException {
        Map<String, Object> entry = new LinkedHashMap<>();
        entry.put("kind", kind);
        entry.put("path", path);
        entry.put("title", bundle.getFileName().toString().replaceFirst("\\" + ENDING + "$", ""));
        entry.put("words", words);
        entry.put("time", time(Paths.get(path)));
        return entry;
    }

    private static long time(Path path) throws IOException {
        return Files.getLastModifiedTime(path).toMillis();
    }

    /** Returns the contents of a project in words; empty for an empty project. */
    static String words(Path folder) {
        try {
            return ProjectWords.of(Project.read(folder));
        } catch (ProjectException e) {
            return "with problems";
        }
    }

    /**
     * Returns a picture of a project from above.
     *
     * @return {@code {"path": the given one, "svg": the picture, empty if there is none}}
     */
    synchronized Map<String, Object> picture(String path) throws IOException {
        Path file = Paths.get(path);
        String key = path + " " + time(file);
        if (!pictures.containsKey(key)) {
            pictures.put(key, draw(file));
        }
        return Map.of("path", path, "svg", pictures.get(key));
    }

    private static String draw(Path file) throws IOException {
        try {
            if (Files.isDirectory(file)) {
                return svg(Project.read(file));
            }
            return Files.size(file) > LARGE ? ""
                : Bundle.check(file, Progress.NONE, project -> List.of(svg(project))).get(0);
        } catch (ProjectException | RuntimeException e) {
            return "";          // the list shows its name and time
        }
    }

    private static String svg(Project project) throws ProjectException {
        try (Simulation world = Simulation.of(project, 0)) {
            return DrawingFiles.svg(new PlanDrawing(Plan.of(world, false)));
        }
    }
}
