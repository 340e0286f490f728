// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** The first robot is the one made first, whatever its name. */
public class RobotOrderTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private List<String> robots() throws Exception {
        return Project.read(project.folder()).getRobots().stream().map(SEARrobot::getName).collect(Collectors.toList());
    }

    private static void robot(String name) {
        new SEARrobot(name).addComponent(new Dynamics(name + "Dynamics", 3));
    }

    private void makeThree() {
        robot("zebra");
        robot("ape");
        robot("mouse");
    }

    @Test
    public void theOneMadeFirstIsTheFirst() throws Exception {
        makeThree();
        assertEquals("[zebra, ape, mouse]", robots().toString());
        try (Simulation simulation = Simulation.of(Project.read(project.folder()), 1)) {
            assertEquals("zebra", simulation.getRobots().get(0).getObject().getName());
        }
    }

    @Test
    public void savingAndLoadingKeepTheOrder() throws Exception {
        makeThree();
        Path bundle = project.getRoot().toPath().resolve("animals.sear");
        Bundle.save(project.folder(), bundle);
        Bundle.newProject(project.folder(), Progress.NONE);
        Bundle.load(bundle, project.folder());
        assertEquals("[zebra, ape, mouse]", robots().toString());
        robot("bee");
        assertEquals("[zebra, ape, mouse, bee]", robots().toString());
    }

    @Test
    public void anImportedRobotIsTheLast() throws Exception {
        robot("ant");
        Path bundle = project.getRoot().toPath().resolve("ant.sear");
        Bundle.save(project.folder(), bundle);
        Bundle.newProject(project.folder(), Progress.NONE);
        robot("zebra");
        robot("mouse");
        Bundle.importRobot(bundle, project.folder(), "ant", Progress.NONE);
        assertEquals("[zebra, mouse, ant]", robots().toString());
        Bundle.newProject(project.folder(), Progress.NONE);
        Bundle.importRobot(bundle, project.folder(), "ant", Progress.NONE);
        assertFalse(project.text("robot/ant.xml"), project.text("robot/ant.xml").contains("<order>"));
    }

    @Test
    public void theSameScriptAgainWritesTheSameFiles() throws Exception {
        makeThree();
        Map<String, String> files = project.files();
        // another program starts: it knows none of the robots made before
        System.setProperty("sear.project", project.getRoot().toPath().resolve("elsewhere").toString());
        robot("other");
        System.setProperty("sear.project", project.folder().toString());
        makeThree();
        assertEquals(files, project.files());
        makeThree();
        assertEquals("in the same program", files, project.files());
        robot("zebra");
        assertEquals("[zebra, ape, mouse]", robots().toString());
        assertEquals("made again alone", files, project.files());
    }

    @Test
    public void filesWithoutAnOrderGoByNameAndStayAsTheyAre() throws Exception {
        for (String name : new String[] {"b", "a"}) {
            project.put("robot/" + name + ".xml", "<SEARrobot><name>" + name + "</name><component>" + name
                + "d</component></SEARrobot>");
            project.put("robot/" + name + "d.xml", "<Dynamics><name>" + name + "d</name><mass>3</mass></Dynamics>");
        }
        project.put("robot/broken.xml", "<SEARrobot><name>broken");
        robot("aa");
        assertTrue(project.text("robot/aa.xml"), project.text("robot/aa.xml").contains("<order>2</order>"));
        project.put("robot/broken.xml", "<Compass><name>broken</name></Compass>");
        assertEquals("[a, b, aa]", robots().toString());
        new SEARrobot("b");
        assertFalse(project.text("robot/a.xml"), project.text("robot/a.xml").contains("<order>"));
    }

    @Test
    public void aSingleRobotsFileHasNoOrder() throws Exception {
        robot("rover");
        assertFalse(project.text("robot/rover.xml"), project.text("robot/rover.xml").contains("<order>"));
    }
}
