package org.myrobotlab.service.sear.panel;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.UUID;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.RunSettings;

/**
 * The world as it would start, for panels while no simulation runs. Panels that are looked at ask again and again; the world is only made when a file
 * of the project has changed since, so that objects made by scripts, by hand or by a bundle are all followed, and nothing is done when nobody asks.
 *
 * <pre>
 * {"stamp": "…"}                                                    the asker has the newest one
 * {"stamp": "…", "world": {"time": 0, "objects": [..], "robots": [..], "sensors": [..]}, "problems": [], "reason": null}
 * {"stamp": "…", "world": null, "problems": [{"file", "line", "field", "value", "legal"}, ..], "reason": null}
 * {"stamp": "…", "world": null, "problems": [], "reason": "…"}      whatever else is in the way
 * </pre>
 *
 * <p>The form of a world stands at {@link WorldJson}; where there is no project yet, it has nothing in it. Any thread; one at a time.
 */
public final class Preview {
    private final Looks looks = new Looks();
    private Map<String, Object> last = Collections.emptyMap();

    /** @param known the stamp that the asker has; empty if none */
    public synchronized Map<String, Object> of(Path folder, String known) {
        String stamp;
        try {
            stamp = stamp(folder);
        } catch (IOException e) {
            return answer("", null, Collections.emptyList(), folder + " can't be read: " + e);
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
            return answer(stamp, WorldJson.empty(), Collections.emptyList(), null);
        }
        try (Simulation start = Simulation.load(folder, RunSettings.fromSystem().seed)) {
            return answer(stamp, new WorldJson(looks).of(start), Collections.emptyList(), null);
        } catch (ProjectException e) {
            return answer(stamp, null, e.getProblems(), null);
        } catch (RuntimeException e) {
            return answer(stamp, null, Collections.emptyList(), "its world can't be made: " + e);
        }
    }

    /** What the shapes of the last world look like, as {@link Looks} tells it. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return looks.of(wanted);
    }

    /** There is no world, and not because of the project. */
    public static Map<String, Object> none(String reason) {
        return answer("", null, Collections.emptyList(), reason);
    }

    private static Map<String, Object> answer(String stamp, Object world, Object problems, String reason) {
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("stamp", stamp);
        answer.put("world", world);
        answer.put("problems", problems);
        answer.put("reason", reason);
        return answer;
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
}
