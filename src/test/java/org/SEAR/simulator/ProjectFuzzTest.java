// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertTrue;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.Fuzz;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProjectException;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Projects with randomly changed files, mostly numbers. SEAR rejects them with a message, or makes a world that steps,
 * with readable sensors and finite poses. It tries an eighth of the number of other files in {@link Fuzz}.
 */
@Category(Slow.class)
public class ProjectFuzzTest {
    private static final int COUNT = Math.max(1, Fuzz.FILES / 8);
    private static final int STEPS = 10;
    private static final Pattern NUMBER = Pattern.compile("(?<=>)[-+0-9.eE]+(?=<)");
    private static final String[] VALUES = {"0", "-0", "-1", "1", "0.5", "90", "180", "-90", "360", "1e-6", "1e-38",
        "1e-45", "1e-300", "1000", "1e6",
        "1e9", "2147483648", "1e30", "1e38", "1e300", "NaN", "Infinity", "-Infinity", "", "x", "1e-3", "0.01", "100",
            "-1000000"};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final Random random = new Random(Fuzz.SEED);
    private int made;

    private Map<String, String> original() throws Exception {
        Path bundle = project.getRoot().toPath().resolve("original.sear");
        try (InputStream in = Bundle.class.getResourceAsStream("golden/version1-sensors.sear")) {
            Files.copy(in, bundle);
        }
        Bundle.load(bundle, project.folder());
        Map<String, String> files = new TreeMap<>(project.files());
        for (String tree : new String[] {"environment/Tree1_name.xml", "environment/old tree.xml"}) {
            Files.delete(project.folder().resolve(tree));
            files.remove(tree);
        }
        files.keySet().removeIf(file -> !file.endsWith(".xml"));
        return files;
    }

    private String changed(String text) {
        switch (random.nextInt(8)) {
            case 0:
                int at = random.nextInt(text.length());
                return text.substring(0, at) + (char) (' ' + random.nextInt(95)) + text.substring(at + 1);
            case 1:
                List<String> lines = new ArrayList<>(List.of(text.split("\n")));
                int line = random.nextInt(lines.size());
                if (random.nextBoolean()) {
                    lines.remove(line);
                } else {
                    lines.add(random.nextInt(lines.size()), lines.get(line));
                }
                return String.join("\n", lines);
            default:
                return withAnotherNumber(text);
        }
    }

    private String withAnotherNumber(String text) {
        List<int[]> places = new ArrayList<>();
        for (Matcher matcher = NUMBER.matcher(text); matcher.find();) {
            places.add(new int[] {matcher.start(), matcher.end()});
        }
        if (places.isEmpty()) {
            return text;
        }
        int[] place = places.get(random.nextInt(places.size()));
        return text.substring(0, place[0]) + VALUES[random.nextInt(VALUES.length)] + text.substring(place[1]);
    }

    private static boolean isFinite(Pose pose) {
        return Double.isFinite(pose.x + pose.y + pose.z + pose.qx + pose.qy + pose.qz + pose.qw);
    }

    private void tryIt(String what) {
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            made++;
            for (int i = 0; i < STEPS; i++) {
                world.step();
            }
            Snapshot snapshot = world.snapshot();
            assertTrue("a pose in " + what, snapshot.environment.stream().allMatch(ProjectFuzzTest::isFinite));
            assertTrue("a robot's pose in " + what, snapshot.robots.stream().allMatch(robot -> isFinite(robot.pose)));
            world.getSensorNames().forEach(world::read);
        } catch (ProjectException e) {
            assertTrue(what + e.getMessage(), e.getMessage().contains("legal: "));
        } catch (RuntimeException | Error e) {
            throw new AssertionError(what, e);
        }
    }

    @Test
    public void changedProjectsAreRefusedOrRun() throws Exception {
        Map<String, String> files = original();
        List<String> names = new ArrayList<>(files.keySet());
        for (int i = 0; i < COUNT; i++) {
            StringBuilder what = new StringBuilder("seed " + Fuzz.SEED + ", project " + i + ":\n");
            Map<String, String> changed = new TreeMap<>();
            for (int count = 1 + random.nextInt(3); count > 0; count--) {
                String file = names.get(random.nextInt(names.size()));
                changed.put(file, changed(changed.getOrDefault(file, files.get(file))));
            }
            for (Map.Entry<String, String> file : changed.entrySet()) {
                project.put(file.getKey(), file.getValue());
                what.append(file.getKey()).append('\n').append(file.getValue()).append('\n');
            }
            tryIt(what.toString());
            for (String file : changed.keySet()) {
                project.put(file, files.get(file));
            }
        }
        assertTrue("made " + made + " of " + COUNT, made > COUNT / 10 && made < COUNT);
    }
}
