// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.LIDAR;
import org.junit.Rule;
import org.junit.Test;
import org.python.util.PythonInterpreter;

/** Warnings about legal but probably unintended values, reported when the object is made. */
public class NoticesTest {
    private static final String MADE = "from org.SEAR.POJOs import Box\nfor i in range(2):\n    Box('post', "
        + "1, 1, 1, 0)\n";

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Rule
    public final SaidRule grammar = new SaidRule();

    private final List<String> said = grammar.said;

    @Test
    public void anObjectOfANameThatTheScriptHasMadeAlready() {
        try (PythonInterpreter python = new PythonInterpreter()) {
            python.exec(MADE);
        }
        assertEquals(said.toString(), 1, said.size());
        assertTrue(said.get(0), said.get(0)
            .startsWith("Box \"post\" has the name of an object that this script has made already"));
    }

    @Test
    public void theSameScriptAgainMakesTheSameObjects() {
        String once = "from org.SEAR.POJOs import Box\nBox('post', 1, 1, 1, 0)\n";
        try (PythonInterpreter python = new PythonInterpreter()) {
            python.exec(once);
            python.exec(once);
        }
        new Box("post", 1, 1, 1, 0);
        new Box("post", 1, 1, 1, 0);
        assertEquals("[]", said.toString());
    }

    @Test
    public void anObjectMadeWhileASimulationRuns() {
        grammar.bench.begin(null, () -> true);
        new Box("late", 1, 1, 1, 0);
        assertEquals("[Box \"late\" was made while a simulation runs: it appears at the next startSimulation()]",
            said.toString());
    }

    @Test
    public void anInvalidLms200FanIsReportedAtItsSetter() {
        LIDAR lidar = new LIDAR("scanner", 8, 180, 0.5);
        lidar.setResolution(0.3);
        lidar.setResolution(0.5);
        assertEquals("[]", said.toString());
        lidar.setPorts("A", "B");
        lidar.setSpread(100);
        assertEquals("[]", said.toString());
        lidar.setSpread(270);
        assertEquals(said.toString(), 1, said.size());
        assertTrue(said.get(0), said.get(0).startsWith("LIDAR \"scanner\": at a port there is an LMS200, and none has "
            + "spread 270 with resolution 0.5"
            + " deg, legal: 100 with 1, 0.5 or 0.25; 180 with 1 or 0.5; without setPorts"));
        assertTrue(said.get(0), said.get(0).endsWith("until then the device starts with 180 and 0.5"));
        lidar.setSpread(180);
        lidar.setResolution(0.25);
        assertEquals(said.toString(), 2, said.size());
        lidar.LMS(0);
        lidar.setResolution(0.3);
        assertEquals(said.toString(), 2, said.size());
    }

    @Test
    public void limitsOfAModelAreReportedAtTheSetter() {
        LIDAR lidar = new LIDAR("scanner");
        lidar.setModel("tim 561");
        lidar.setPorts("A", "B");
        lidar.setSpread(180);
        lidar.setRange(10);
        assertEquals("[]", said.toString());
        lidar.setRange(11);
        assertEquals("[LIDAR \"scanner\": at a port there is a TiM561, which reports at most 10 m, but the range is 11 "
            + "m: read greater distances with sear.getLidarResult(\"scanner\")]", said.toString());
        said.clear();
        lidar.setResolution(0.25);
        assertEquals("[LIDAR \"scanner\": at a port there is a TiM561, and none has spread 180 with resolution 0.25 "
            + "deg, legal: up to 270 with"
            + " 0.3333333; without setPorts every fan, read with sear.getLidarResult(\"scanner\"); setModel has it "
            + "with LMS111, UTM-30LX, RPLIDAR-A1,"
            + " CoLa; until then the device starts with 270 and 0.3333333]", said.toString());
        said.clear();
        lidar.setModel("LMS111");
        assertEquals("[]", said.toString());
        assertEquals("LMS111", lidar.getModel());
        assertEquals("[20.0, 270.0, 0.5, 1.0E8]",
            Arrays.asList(lidar.getRange(), lidar.getSpread(), lidar.getResolution(),
            (double) lidar.getBaud()).toString());
    }

    @Test
    public void foldersOfTheOtherSpelling() throws Exception {
        new Box("box", 1, 1, 1, 0);
        project.put("environments/lost.xml", project.text("environment/box.xml"));
        project.put("robots/lost.xml", project.text("environment/box.xml"));
        List<String> warnings = Project.read(project.folder()).getWarnings();
        assertEquals("the folder environments/ of the project is not read: its objects belong into environment/",
            warnings.get(0));
        assertEquals("the folder robots/ of the project is not read: its objects belong into robot/", warnings.get(1));
    }

    /** Returns the answer to a script that lists foreign objects before the start. */
    private String ofOthers(String script, String... names) {
        try (PythonInterpreter python = new PythonInterpreter()) {
            python.set("names", Arrays.asList(names));
            python.set("bench", grammar.bench);
            python.exec("from org.SEAR.POJOs import Box\n" + script + "\nanswer = bench.ofOthers(names)\n");
            return python.get("answer").toString();
        }
    }

    @Test
    public void foreignObjectsAreNamedInOneLine() {
        String answer = ofOthers("Box('new name', 1, 1, 1, 0)", "new name", "old name");
        assertEquals("in the project, but not made by this script: \"old name\" (from an earlier run or another "
            + "script; call sear.newProject() first to start with an empty project)", answer);
        answer = ofOthers("Box('new name', 1, 1, 1, 0)", "a", "b", "c", "d", "e", "f", "g");
        assertTrue(answer, answer.contains("\"a\", \"b\", \"c\", \"d\", \"e\" and 2 more (from"));
    }

    @Test
    public void objectsOfALoadedProjectAreNotReported() {
        assertEquals("", ofOthers("", "old name"));
        assertEquals("", ofOthers("bench.projectTaken()\nBox('new name', 1, 1, 1, 0)", "old name"));
        assertEquals("", ofOthers("Box('new name', 1, 1, 1, 0)", "new name"));
        assertEquals("not called by a script", "", grammar.bench.ofOthers(List.of("old name")));
    }
}
