// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.Map;
import org.SEAR.project.ProjectRule;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;

/** With two SEAR services in one MyRobotLab, the one with the running simulation reports warnings about new objects. */
public class TwoSearServicesTest {
    private static final String LATE = "was made while a simulation runs";

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Python python;
    private Heard first;
    private Heard second;

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
        python = (Python) Runtime.start("twoPython", "Python");
        first = hearing("firstSear");
        second = hearing("secondSear");
    }

    private static Heard hearing(String name) {
        SEAR sear = (SEAR) Runtime.start(name, "SEAR");
        Heard heard = (Heard) Runtime.start(name + "Heard", "Heard");
        sear.addListener("publishStatus", heard.getName(), "onStatus");
        return heard;
    }

    /**
     * Runs a script that starts one service's simulation and makes an object. Then each service publishes a last
     * message.
     */
    private void script(String running) throws Exception {
        python.execAndWait("from org.SEAR.POJOs import Box\n"
            + "first = Runtime.start('firstSear', 'SEAR')\nsecond = Runtime.start('secondSear', 'SEAR')\n"
            + running + ".startSimulation()\nBox('late in " + running + "', 1, 1, 1, 0)\n"
            + running + ".stopSimulation()\n"
            + "first.info('end of " + running + "')\nsecond.info('end of " + running + "')\n");
        for (Heard heard : Arrays.asList(first, second)) {
            assertTrue(heard.getStatuses().toString(), heard.awaitStatus("end of " + running));
        }
    }

    @Test
    public void onlyTheServiceWithTheSimulationReportsALateObject() throws Exception {
        script("first");
        assertTrue(first.getStatuses().toString(), first.getStatuses().toString()
            .contains("Box \"late in first\" " + LATE));
        assertFalse(second.getStatuses().toString(), second.getStatuses().toString().contains(LATE));
        script("second");
        assertTrue(second.getStatuses().toString(), second.getStatuses().toString()
            .contains("Box \"late in second\" " + LATE));
        assertFalse(first.getStatuses().toString(), first.getStatuses().toString()
            .contains("late in second\" " + LATE));
    }

    private static void refused(String call, ThrowingRunnable work) {
        String message = assertThrows(call, IllegalStateException.class, work).getMessage();
        assertTrue(message, message.contains(call + " needs the simulation of service firstSear to be stopped"));
    }

    @Test
    public void noServiceReplacesTheProjectOfTheOthersSimulation() throws Exception {
        SEAR simulating = (SEAR) Runtime.getService("firstSear");
        SEAR other = (SEAR) Runtime.getService("secondSear");
        Path bundle = temporary.getRoot().toPath().resolve("copy.sear");
        other.saveProject(bundle.toString());
        String data = Base64.getEncoder().encodeToString(Files.readAllBytes(bundle));
        simulating.startSimulation();
        Map<String, String> before = ProjectRule.files(temporary.getRoot().toPath().resolve("SEARproject"));
        refused("newProject", other::newProject);
        refused("loadProject", () -> other.loadProject(bundle.toString()));
        refused("importRobot", () -> other.importRobot(bundle.toString(), ""));
        refused("importEnvironment", () -> other.importEnvironment(bundle.toString()));
        refused("loadProject", () -> other.uploadProject("copy.sear", 0, 1, data));
        assertEquals(before, ProjectRule.files(temporary.getRoot().toPath().resolve("SEARproject")));
        assertTrue(simulating.isSimulating());
        simulating.stopSimulation();
        other.newProject();
    }

    @Test
    public void anEditOfOneServiceMovesTheObjectInTheOthersSimulation() throws Exception {
        SEAR simulating = (SEAR) Runtime.getService("firstSear");
        simulating.startSimulation();
        ((SEAR) Runtime.getService("secondSear"))
            .edit(Map.of("do", "set", "object", "roomba", "set", Map.of("x", 1.5)));
        assertEquals(1.5, simulating.getPose("roomba")[0], 0.01);
    }

    @Test
    public void aReleasedServiceLeavesTheOther() throws Exception {
        Runtime.releaseService("secondSear");
        python.execAndWait("from org.SEAR.POJOs import Box\nfirst = Runtime.start('firstSear', 'SEAR')\n"
            + "for i in range(2):\n    Box('post', 1, 1, 1, 0)\nfirst.info('that was all')\n");
        assertTrue(first.getStatuses().toString(), first.awaitStatus("that was all"));
        String again = "has the name of an object that this script has made already";
        assertTrue(first.getStatuses().toString(), first.getStatuses().toString().contains(again));
        assertFalse(second.getStatuses().toString(), second.getStatuses().toString().contains(again));
    }
}
