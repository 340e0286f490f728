// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.SEAR.project.problems.Problem;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;
import org.myrobotlab.service.sear.files.Edits;

/** Calls that edit a project, with and without a running simulation. */
public class EditCallsTest {
    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Path folder;
    private SEAR sear;

    @Before
    public void start() {
        folder = TestWorld.build(temporary.getRoot().toPath());
        sear = (SEAR) Runtime.start("editSear", "SEAR");
    }

    @Test
    public void scriptsEditUndoAndRedo() {
        Map<String, Object> answer = sear.edit(Map.of("do", "add", "type", "Box", "set", Map.of("x", 1)));
        assertEquals("box1", answer.get("object"));
        assertEquals("add box1", answer.get("undo"));
        assertNull(answer.get("note"));
        assertTrue(Files.exists(folder.resolve("environment/box1.xml")));
        assertEquals("add box1", sear.undo().get("redo"));
        assertFalse(Files.exists(folder.resolve("environment/box1.xml")));
        sear.redo();
        assertTrue(Files.exists(folder.resolve("environment/box1.xml")));
        assertEquals("add box1", sear.getEdits().get("undo"));
        String refusal = assertThrows(IllegalStateException.class,
            () -> sear.edit(Map.of("do", "set", "object", "box1", "set", Map.of("mass", -1)))).getMessage();
        assertEquals("environment/box1.xml: mass is \"-1\", legal: 0, or a number from 0.000001 "
            + "to 1000000 kg", refusal);
        assertEquals("1", ((Map<?, ?>) sear.getProjectObject("box1").get("values")).get("x"));
        assertTrue(sear.getProjectObject("box7").get("gone").toString().contains("box7"));
    }

    @Test
    public void anInterruptedEditIsUndoneBeforeTheProjectIsRead() throws Exception {
        sear.edit(Map.of("do", "add", "type", "Box"));
        sear.edit(Map.of("do", "add", "type", "Sphere"));
        Runtime.releaseService("editSear");
        Files.writeString(folder.resolve(".edits/state"), "done 1 doing 2\n");
        sear = (SEAR) Runtime.start("editSear", "SEAR");
        assertFalse(Files.exists(folder.resolve("environment/sphere1.xml")));
        assertTrue(Files.exists(folder.resolve("environment/box1.xml")));
        assertEquals("add box1", sear.getEdits().get("undo"));
    }

    @Test
    public void panelsGetErrorsAsAnswers() throws Exception {
        Edits edits = new Edits();
        Map<String, Object> answer = edits.attempt(
            Map.of("do", "set", "object", "wall", "set", Map.of("mass", "heavy"), "page", "a"));
        assertEquals(false, answer.get("done"));
        assertEquals("a", answer.get("page"));
        Problem problem = (Problem) ((List<?>) answer.get("problems")).get(0);
        assertEquals("mass", problem.field);
        assertEquals("environment/wall.xml", problem.file);
        assertTrue(edits.attempt(Map.of("do", "undo")).get("reason").toString().startsWith("there is nothing to undo"));
        assertTrue("an object without a name is none", sear.getProjectObject(null).containsKey("gone"));
        assertEquals("do", ((Problem) ((List<?>) edits.attempt(null).get("problems")).get(0)).field);
    }

    @Test
    public void movesApplyDuringARunAndOtherEditsWait() {
        sear.startSimulation();
        sear.simSleep(0.5);
        assertEquals(TestWorld.WALL - 0.15, sear.getDistanceResult("ping"), 0.02);
        assertNull(sear.edit(Map.of("do", "set", "object", "wall", "set", Map.of("z", 1.1))).get("note"));
        sear.simSleep(0.1);
        assertEquals(1 - 0.15, sear.getDistanceResult("ping"), 0.02);
        assertNull(sear.undo().get("note"));
        sear.simSleep(0.1);
        assertEquals(TestWorld.WALL - 0.15, sear.getDistanceResult("ping"), 0.02);
        assertNull(sear.edit(Map.of("do", "set", "object", "roomba/drive", "set", Map.of("x", 3, "ry", 90)))
            .get("note"));
        sear.simSleep(0.5);
        assertEquals(3, sear.getPose("roomba")[0], 0.01);
        assertEquals("a simulation runs: this takes effect at its next start",
            sear.edit(Map.of("do", "set", "object", "wall", "set", Map.of("height", 3))).get("note"));
        assertEquals(0.1, sear.getPose("wall")[2] - TestWorld.WALL, 1e-6);
    }

    /** Moves the robot as the tab's drag does: onto a step, and by undo back to where it had driven. */
    @Test
    public void aRobotMovedDuringARunStandsOnItsSupportAndUndoMovesItBack() throws Exception {
        sear.edit(Map.of("do", "add", "type", "Box", "name", "step",
            "set", Map.of("x", 3, "y", 0.15, "z", -3, "length", 2, "width", 2, "height", 0.3)));
        sear.startSimulation();
        sear.simSleep(0.5);
        assertNull(sear.edit(Map.of("do", "set", "object", "roomba/drive", "set", Map.of("ry", 90))).get("note"));
        sear.simSleep(0.5);
        double height = sear.getPose("roomba")[1];
        double start = Double.parseDouble(
            String.valueOf(((Map<?, ?>) sear.getProjectObject("roomba").get("values")).get("y")));
        assertNull(sear.edit(Map.of("do", "set", "object", "roomba", "stand", true, "set", Map.of("x", 1)))
            .get("note"));
        sear.simSleep(0.5);
        assertEquals(1, sear.getPose("roomba")[0], 0.01);
        assertEquals(height, sear.getPose("roomba")[1], 0.01);
        Map<?, ?> values = (Map<?, ?>) sear.getProjectObject("roomba").get("values");
        assertEquals("it has the height that it had", start, Double.parseDouble(String.valueOf(values.get("y"))), 0);
        assertNull(sear.edit(Map.of("do", "set", "object", "roomba", "stand", true, "set", Map.of("x", "3", "z", "-3")))
            .get("note"));
        sear.simSleep(0.5);
        assertEquals(-3, sear.getPose("roomba")[2], 0.01);
        assertEquals("on the step", height + 0.3, sear.getPose("roomba")[1], 0.01);
        values = (Map<?, ?>) sear.getProjectObject("roomba").get("values");
        assertEquals("also at the next start", start + 0.3, Double.parseDouble(String.valueOf(values.get("y"))), 0.01);
        sear.undo();
        sear.simSleep(0.5);
        assertEquals(1, sear.getPose("roomba")[0], 0.01);
        assertEquals(height, sear.getPose("roomba")[1], 0.01);
        sear.redo();
        sear.simSleep(0.5);
        assertEquals(-3, sear.getPose("roomba")[2], 0.01);
    }
}
