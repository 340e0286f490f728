// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/**
 * Bundles of released versions stay readable. A file of this folder is never changed or removed; new formats add files.
 */
public class GoldenBundlesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void allOpen() throws Exception {
        File[] bundles = Paths.get(GoldenBundlesTest.class.getResource("golden").toURI()).toFile()
            .listFiles((dir, name) -> name.endsWith(".sear"));
        assertTrue(bundles.length >= 1);
        for (File bundle : bundles) {
            Project read = Bundle.load(bundle.toPath(), project.folder());
            assertEquals(bundle.getName(), 1, read.getRobots().size());
            Bundle.save(project.folder(), project.getRoot().toPath().resolve("again.sear"));
        }
    }

    @Test
    public void versionOneKeepsItsMeaning() throws Exception {
        Path bundle = Paths.get(GoldenBundlesTest.class.getResource("golden/version1-sensors.sear").toURI());
        Project read = Bundle.load(bundle, project.folder());
        assertEquals(16, read.getEnvironment().size());
        SEARrobot robot = read.getRobots().get(0);
        assertEquals("myRoomba", robot.getName());
        assertEquals(4, robot.getWheels().size());
        assertEquals(-0.16, robot.getWheels().get(1).getX(), 0);
        assertEquals(-80.865, ((GPS) part(robot, "gpsUnit1")).getLongitude(), 0);
        Distance noisy = (Distance) part(robot, "noisyPing");
        assertEquals(3, noisy.getCones().size());
        assertEquals(40, noisy.getCones().get(2).getYaw(), 0);
        assertEquals(0.05, noisy.getNoise().getDropout(), 0);
    }

    private static SearObject part(SEARrobot robot, String name) {
        return robot.getComponents().stream().filter(c -> c.getName().equals(name)).findFirst().get();
    }
}
