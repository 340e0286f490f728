// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.documents.DocBlock;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Robots from documented parts, with defaults for everything else, stand and drive. */
public class FirstRobotTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static void robot(Dynamics drive, double axle, double casterZ, double casterRadius, double casterY) {
        new Floor("floor", 20, 20);
        SEARrobot robot = new SEARrobot("first");
        robot.move(0, 0.06, 0);
        robot.addComponent(drive);
        robot.addComponent(new Box("body", 0.2, 0.3, 0.08, 0));
        robot.addWheel(new Wheel("left", 0.05, 0.03, 1, 0.12, 0, axle));
        robot.addWheel(new Wheel("right", 0.05, 0.03, 1, -0.12, 0, axle));
        robot.addWheel(new Wheel("caster", casterRadius, 0.02, 0, 0, casterY, casterZ));
    }

    private void standsAndDrives(String what) throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            assertEquals(what, "[]", simulation.snapshot().warnings.toString());
            Worlds.run(simulation, 3);
            String name = simulation.getRobots().get(0).getObject().getName();
            Pose from = simulation.getPose(name);
            assertEquals(what + " leans, degrees", 0,
                Math.toDegrees(Math.acos(Math.min(1, from.rotate(0, 1, 0)[1]))), 1);
            simulation.getRobots().get(0).drive(0.2, Double.POSITIVE_INFINITY);
            Worlds.run(simulation, 5);
            Pose to = simulation.getPose(name);
            assertEquals(what, 1, Math.hypot(to.x - from.x, to.z - from.z), 0.02);
            assertEquals(what + " leans, degrees", 0, Math.toDegrees(Math.acos(Math.min(1, to.rotate(0, 1, 0)[1]))), 1);
        }
    }

    /**
     * The springs press the driven wheels down: the casters carry only their share, and the driven wheels have grip.
     */
    @Test
    public void oneOfAHundredTonnesStartsAsFastAsOthers() throws Exception {
        new Floor("floor", 200, 200);
        SEARrobot robot = new SEARrobot("giant");
        robot.addComponent(new Dynamics("drive", 1e5));
        Box body = new Box("body", 6, 12, 2, 1e5);
        body.move(0, 2, 0);
        robot.addComponent(body);
        robot.addWheel(new Wheel("left", 0.8, 0.5, 1, 3, 0.2, 0));
        robot.addWheel(new Wheel("right", 0.8, 0.5, 1, -3, 0.2, 0));
        robot.addWheel(new Wheel("front", 0.8, 0.5, 0, 0, 0.2, 5));
        robot.addWheel(new Wheel("back", 0.8, 0.5, 0, 0, 0.2, -5));
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 2);
            simulation.getRobots().get(0).drive(4, Double.POSITIVE_INFINITY);
            Worlds.run(simulation, 3);
            assertEquals("2 m while it speeds up by 4 m/s in a second, and 8 m", 10,
                simulation.getPose("giant").z, 0.2);
        }
    }

    @Test
    public void itStandsLevelAndDrives() throws Exception {
        for (double mass : new double[] {0.2, 2, 50}) {
            robot(new Dynamics("drive", mass), 0.1, -0.1, 0.05, 0);
            standsAndDrives(mass + " kg, caster behind");
            robot(new Dynamics("drive", mass), 0.05, -0.15, 0.03, -0.02);
            standsAndDrives(mass + " kg, small caster");
            robot(new Dynamics("drive", mass), -0.1, 0.1, 0.02, 0);
            standsAndDrives(mass + " kg, caster in front that does not reach as low");
        }
    }

    @Test
    public void theOneOfTheDocumentsDoes() throws Exception {
        List<String> blocks = DocBlock.of("docs/projects.md", "xml");
        project.put("robot/rover.xml", blocks.get(0)
            .replace("  <component>frontEye</component>   <!-- robot/frontEye.xml -->\n", ""));
        project.put("robot/drive.xml", blocks.get(1));
        new Floor("floor", 20, 20);
        standsAndDrives("docs/projects.md");
    }

    /** The load on each wheel can't be determined. */
    @Test
    public void unplacedWheelsAreReportedAndTheRobotLeansOnItsBody() throws Exception {
        for (int wheels = 1; wheels <= 2; wheels++) {
            new Floor("floor", 20, 20);
            SEARrobot robot = new SEARrobot("first");
            robot.addComponent(new Dynamics("drive", 2, 0, 0.1, 0, 0, 0, 0));
            robot.addComponent(new Box("body", 0.3, 0.4, 0.1, 2));
            robot.addWheel(new Wheel("left", 0.08, 0.03));
            if (wheels == 2) {
                robot.addWheel(new Wheel("right", 0.08, 0.03));
            }
            try (Simulation simulation = Worlds.start(project)) {
                assertEquals(wheels == 2, simulation.snapshot().warnings.toString()
                    .contains("robot first has its wheels left and right at the same"
                    + " place, x 0, z 0 m, so it can't stand on them. Give each its place"));
                Worlds.run(simulation, 2);
                simulation.getRobots().get(0).drive(0.2, Double.POSITIVE_INFINITY);
                Worlds.run(simulation, 2);
                Pose pose = simulation.getPose("first");
                assertEquals(wheels + " wheels: " + pose, 0.08, pose.y, 0.03);
                assertTrue(wheels + " wheels: " + pose, Math.abs(pose.x) < 0.5 && Math.abs(pose.z) < 0.5);
            }
        }
    }

    @Test
    public void tooWeakSpringsAreReported() throws Exception {
        robot(new Dynamics("soft", 2, 40, 0.3, 0.4, 10000, 0.2), 0.05, -0.15, 0.05, 0);
        try (Simulation simulation = Worlds.start(project)) {
            String warnings = simulation.snapshot().warnings.toString();
            assertTrue(warnings, warnings.contains("robot first falls over forwards or backwards at rest: its springs "
                + "of stiffness 40 are too soft for its centre of mass at x 0.000, y 0.000, z "));
        }
    }
}
