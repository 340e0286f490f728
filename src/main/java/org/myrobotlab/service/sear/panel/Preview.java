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
 * The world as it would start, for panels while no simulation runs. Panels that are looked at ask again and again; the world is only made when a file
 * of the project has changed since, so that objects made by scripts, by hand or by a bundle are all followed, and nothing is done when nobody asks.
 * Who has the newest one gets its stamp only. Where there is no project yet, its world has nothing in it. Any thread; one at a time.
 */
public final class Preview {
    private final LookTable looks = new LookTable();
    private Map<String, Object> last = Collections.emptyMap();

    /** @param known the stamp that the asker has; empty if none */
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
            return new Answer(stamp, null, List.of(), "its world can't be made: " + e).map();
        }
    }

    /** What the shapes of the last world look like, as {@link LookTable} tells it. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return looks.of(wanted);
    }

    /** There is no world, and not because of the project. */
    public static Map<String, Object> none(String reason) {
        return new Answer("", null, List.of(), reason).map();
    }

    /** Differs when any file of the folder has changed: by name, size, time or, where there are such, by its number on the disk. */
    private static String stamp(Path folder) throws IOException {
        Map<String, String> files = new TreeMap<>();
        if (Files.isDirectory(folder)) {
            Files.walkFileTree(folder, new SimpleFileVisitor<Path>() {
                @Override
                public FileVisitResult visitFile(Path file, BasicFileAttributes is) {
                    if (!file.getFileName().toString().startsWith(".")) {       // else it is still being written
                        files.put(file.toString(), is.size() + " " + is.lastModifiedTime().toInstant() + " " + is.fileKey());
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

    /** What a panel gets. */
    private static final class Answer extends JsonForm {
        /** What to ask with again; empty if there is nothing to wait for. */
        final String stamp;
        /** Empty if something is in the way. */
        final Optional<WorldState> world;
        final List<Problem> problems;
        /** What is in the way that is no problem of the project. */
        final Optional<String> reason;

        Answer(String stamp, WorldState world, List<Problem> problems, String reason) {
            this.stamp = stamp;
            this.world = Optional.ofNullable(world);
            this.problems = problems;
            this.reason = Optional.ofNullable(reason);
        }
    }
}
