// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** Velocities and pushes by calls and by objects of a script, in lock-step. */
public class BodyCallsTest {
    private static final double G = 9.81;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Path file;
    private Box crate;
    private SEAR sear;

    @Before
    public void start() {
        Path folder = TestWorld.build(temporary.getRoot().toPath());
        crate = new Box("crate", 0.2, 0.2, 0.2, 2);
        crate.move(5, 0.1, -5);
        file = folder.resolve("environment/crate.xml");
        sear = (SEAR) Runtime.start("bodySear", "SEAR");
    }

    @Test
    public void anObjectActsOnTheRunningWorldAndNotOnItsFile() throws Exception {
        crate.setVelocity(0, 0, 0.5);
        sear.startSimulation();
        sear.simSleep(2);
        double z = sear.getPose("crate")[2];
        assertEquals("it slid on from the start, to the way of a step", -5 + 0.25 / (2 * 0.64 * G), z, 0.5 / 60);
        String before = Files.readString(file);
        crate.setVelocity(0, 5, 0);
        crate.setSpin(0, 360, 0);
        sear.simSleep(0.5);
        assertEquals("it is thrown up", 0.1 + 2.5 - G / 8, sear.getPose("crate")[1], 0.01);
        assertEquals("half turned", 180, Math.abs(sear.getPose("crate")[4]), 1);
        assertEquals("the file says with what it starts", before, Files.readString(file));
        sear.stopSimulation();
        crate.setVelocity(1, 0, 0);
        assertTrue(Files.readString(file), Files.readString(file).contains("<velocityX>1</velocityX>"));
    }

    @Test
    public void anObjectMadeDuringARunAppearsAtTheNextStart() throws Exception {
        sear.startSimulation();
        sear.simSleep(1);
        double[] pose = sear.getPose("crate");
        Box again = new Box("crate", 0.2, 0.2, 0.2, 2);
        again.move(5, 0.1, -5);
        again.setVelocity(2, 0, 0);
        sear.simSleep(0.5);
        assertEquals("that of the running world stays", pose[0], sear.getPose("crate")[0], 1e-4);
        assertTrue(Files.readString(file), Files.readString(file).contains("<velocityX>2</velocityX>"));
    }

    @Test
    public void aPushSlidesIt() {
        sear.startSimulation();
        sear.simSleep(1);
        sear.push("crate", Arrays.asList(40, 0.0, 0), 0.25);
        sear.simSleep(3);
        double friction = 0.64 * 2 * G;
        double speed = (40 - friction) / 2 * 0.25;
        double way = speed / 2 * 0.25 + speed * speed / (2 * 0.64 * G);
        assertEquals("to the way of two steps", 5 + way, sear.getPose("crate")[0], 2 * speed / 60);
    }

    @Test
    public void callsMoveObjectsAndRobots() {
        sear.startSimulation();
        sear.simSleep(1);
        sear.setVelocity("roomba", 0, 2, 0);
        sear.setVelocity("crate", 0, 3, 0);
        sear.setSpin("crate", 0, -90, 0);
        sear.simSleep(0.2);
        assertTrue(sear.getPose("roomba")[1] > 0.15);
        assertEquals(0.1 + 0.6 - G * 0.02, sear.getPose("crate")[1], 0.01);
        assertEquals(-18, sear.getPose("crate")[4], 0.5);
    }

    @Test
    public void massPropertiesAreThoseOfTheObjectInItsFrame() {
        sear.startSimulation();
        Map<String, Object> crate = sear.getMassProperties("crate");
        double moment = 2 * 2 * 0.2 * 0.2 / 12;
        assertEquals(2, (Double) crate.get("mass"), 1e-12);
        assertEquals(List.of(0.0, 0.0, 0.0), crate.get("centre"));
        List<?> rows = (List<?>) crate.get("tensor");
        for (int i = 0; i < 9; i++) {
            assertEquals(i % 4 == 0 ? moment : 0, (Double) ((List<?>) rows.get(i / 3)).get(i % 3), 1e-12);
        }
        assertEquals("a robot has all of its mass", 4, (Double) sear.getMassProperties("roomba").get("mass"), 1e-12);
        refused("nothing with a mass is named \"nothing\", legal: an object with a mass, or a robot",
            () -> sear.getMassProperties("nothing"));
        refused("the name is missing (None)", () -> sear.getMassProperties(null));
    }

    private void refused(String part, Runnable call) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, call::run);
        assertTrue(e.getMessage(), e.getMessage().contains(part));
    }

    @Test
    public void wrongCallsAreReportedWithTheLegalRange() {
        assertThrows(IllegalStateException.class, () -> sear.push("crate", List.of(1, 0, 0), 1));
        sear.startSimulation();
        refused("legal: three numbers", () -> sear.push("crate", List.of(1, 0), 1));
        refused("legal: three numbers", () -> sear.push("crate", null, 1));
        refused("push for -1.0 s", () -> sear.push("crate", List.of(1, 0, 0), -1));
        refused("wall is fixed", () -> sear.push("wall", List.of(1, 0, 0), 1));
        refused("the name is missing", () -> sear.setSpin(null, 1, 0, 0));
        refused("-1000.0 to 1000.0 m/s", () -> sear.setVelocity("crate", 2000, 0, 0));
    }
}
