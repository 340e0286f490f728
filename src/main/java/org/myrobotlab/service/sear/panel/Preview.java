// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.UUID;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.RunSettings;

/**
 * The start state of the project's world for panels while no simulation runs. Visible panels poll it. SEAR loads the
 * world only after a file of the project has changed, by a script, by hand or by a bundle. A panel that has the newest
 * state gets its stamp only. Without a project the world is empty. Any thread; one at a time.
 */
public final class Preview {
    private final LookTable looks = new LookTable();
    private Map<String, Object> last = Collections.emptyMap();

    /** @param known stamp that the caller has; empty if none */
    public synchronized Map<String, Object> of(Path folder, String known) {
        String stamp;
        try {
            stamp = stamp(folder);
        } catch (IOException e) {
            return none(folder + " can't be read: " + e);
        }
        if (stamp.equals(known)) {
            return Collections.singletonMap("stamp", stamp);
        }
        if (!stamp.equals(last.get("stamp"))) {
            last = make(folder, stamp);
        }
        return last;
    }

    private Map<String, Object> make(Path folder, String stamp) {
        if (!Files.isDirectory(folder)) {
            return new Answer(stamp, new WorldState(), List.of(), null).map();
        }
        try (Simulation start = Simulation.load(folder, RunSettings.fromSystem().seed)) {
            return new Answer(stamp, new WorldJson(looks, true).whole(start, new WorldState()), List.of(), null).map();
        } catch (ProjectException e) {
            return new Answer(stamp, null, e.getProblems(), null).map();
        } catch (RuntimeException e) {
            return new Answer(stamp, null, List.of(), "the world can't be created: " + e).map();
        }
    }

    /** Returns looks of the last world's shapes, see {@link LookTable#of}. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return looks.of(wanted);
    }

    /** Returns an answer without a world, for a reason outside the project. */
    public static Map<String, Object> none(String reason) {
        return new Answer("", null, List.of(), reason).map();
    }

    /**
     * Returns a stamp that changes with any file of the folder: by name, size, time or file key, if the system has one.
     */
    private static String stamp(Path folder) throws IOException {
        Map<String, String> files = new TreeMap<>();
        if (Files.isDirectory(folder)) {
            Files.walkFileTree(folder, new SimpleFileVisitor<Path>() {
                @Override
                public FileVisitResult visitFile(Path file, BasicFileAttributes is) {
                    if (!file.getFileName().toString().startsWith(".")) {       // else the file is still being written
                        files.put(file.toString(), is.size() + " " + is.lastModifiedTime().toInstant() + " "
                            + is.fileKey());
                    }
                    return FileVisitResult.CONTINUE;
                }

                @Override
                public FileVisitResult visitFileFailed(Path file, IOException gone) {
                    return FileVisitResult.CONTINUE;
                }

                @Override
                public FileVisitResult postVisitDirectory(Path directory, IOException gone) {
                    return FileVisitResult.CONTINUE;
                }
            });
        }
        String all = folder + " " + Files.isDirectory(folder) + " " + files;
        return UUID.nameUUIDFromBytes(all.getBytes(StandardCharsets.UTF_8)).toString();
    }

    /** The answer to a panel. */
    private static final class Answer extends JsonForm {
        /** Stamp for the next request; empty if polling is useless. */
        final String stamp;
        /** Empty if the world can't be loaded. */
        final Optional<WorldState> world;
        final List<Problem> problems;
        /** A reason outside the project why there is no world. */
        final Optional<String> reason;

        Answer(String stamp, WorldState world, List<Problem> problems, String reason) {
            this.stamp = stamp;
            this.world = Optional.ofNullable(world);
            this.problems = problems;
            this.reason = Optional.ofNullable(reason);
        }
    }
}
