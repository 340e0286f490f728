// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.SEAR.HowMany;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.Slow;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.xml.Xml;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Random projects: written files are read, written again unchanged, saved, loaded and saved again with the same bytes.
 * {@code -Dsear.randomProjects=} sets their number; the default is 200, or 1000 with {@code -Pfull}.
 */
@Category(Slow.class)
public class RandomProjectsTest {
    private static final int PROJECTS = HowMany.of("sear.randomProjects", 1000);
    /** Every n-th project also passes through a bundle. */
    private static final int EVERY = 10;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void roundTrip() throws Exception {
        long first = Long.getLong("sear.seed", 20261121);
        System.out.println("random projects from seed " + first);
        for (long seed = first; seed < first + PROJECTS; seed++) {
            ProjectSwap.delete(project.folder());
            new RandomProjects(seed).create();
            if (Files.exists(project.folder())) {
                assertEquals("seed " + seed, project.files(), rewritten(Project.read(project.folder())));
                if (seed % EVERY == 0) {
                    assertBundle(seed);
                }
            }
        }
    }

    private static Map<String, String> rewritten(Project read) {
        Map<String, String> files = new TreeMap<>();
        read.getEnvironment().forEach(o -> put(files, "environment/", o));
        for (SEARrobot robot : read.getRobots()) {
            put(files, "robot/", robot);
            robot.getComponents().forEach(o -> put(files, "robot/", o));
        }
        return files;
    }

    private static void put(Map<String, String> files, String folder, SearObject object) {
        byte[] bytes = Xml.write(object).getBytes(StandardCharsets.UTF_8);
        files.put(folder + object.getName() + ".xml", new String(bytes, StandardCharsets.ISO_8859_1));
    }

    private void assertBundle(long seed) throws Exception {
        Path place = project.getRoot().toPath();
        Bundle.save(project.folder(), place.resolve("a.sear"));
        Bundle.load(place.resolve("a.sear"), place.resolve("copy"));
        Bundle.save(place.resolve("copy"), place.resolve("b.sear"));
        assertArrayEquals("seed " + seed, Files.readAllBytes(place.resolve("a.sear")),
            Files.readAllBytes(place.resolve("b.sear")));
    }
}
