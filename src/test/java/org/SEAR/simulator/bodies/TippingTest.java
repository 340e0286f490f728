// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.edit.ProjectEditor;
import org.SEAR.project.edit.RobotTemplates;
import org.SEAR.robot.Stability;
import org.SEAR.simulator.ProjectCheck;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Centre of mass of a robot, and its effect on stability. */
public class TippingTest {
    private static final double RADIUS = 0.05;
    private static final double REST = 0.02;
    private static final double STIFFNESS = 4000;
    /** Height of the axles of four loaded wheels below their mounts, metres. */
    private static final double HANGING = REST - 9.81 / (4 * STIFFNESS);

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Makes a flat chassis with a mast, its wheels 0.3 m apart in width and 0.4 m in length. */
    private static SEARrobot tower(double chassis, double mast, double mastX, double height) {
        SEARrobot robot = new SEARrobot("tower");
        robot.addComponent(new Dynamics("drive", chassis + mast, STIFFNESS, 0.5, 0.5, 10000, REST, 0, RADIUS + HANGING,
            0, 0, 0, 0));
        robot.addComponent(new Box("chassis", 0.2, 0.3, 0.02, chassis));
        Box box = new Box("mast", 0.05, 0.05, 0.05, mast);
        box.move(mastX, height, 0);
        robot.addComponent(box);
        for (int side : new int[] {1, -1}) {
            for (int end : new int[] {1, -1}) {
                robot.addWheel(new Wheel("wheel" + side + end, RADIUS, 0.02, 1, side * 0.15, 0, end * 0.2));
            }
        }
        return robot;
    }

    @Test
    public void theMassesOfItsPartsSayWhereItsCentreOfMassIs() throws Exception {
        new Floor("floor", 10, 10);
        tower(3, 1, 0.1, 0.4);
        Stability stability = Worlds.start(project).getRobots().get(0).getStability();
        assertArrayEquals(new double[] {0.025, 0.1, 0}, stability.getCentre(), 1e-6);
        assertEquals(Math.toDegrees(Math.atan2(0.125, 0.1 + RADIUS + HANGING)), stability.degrees, 1e-3);
        assertFalse(stability.isCritical());
        assertFalse(stability.getWords(), stability.getWords().contains("middle"));
    }

    /** With fewer than two masses, SEAR assumes the centre of mass in the middle of the wheels. */
    @Test
    public void withoutMassesTheMiddleOfTheWheelsCounts() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = tower(0.001, 0.001, 0.14, 0.4);
        robot.getComponents().forEach(part -> {
            if (part instanceof Box) {
                ((Box) part).setMass(part.getName().equals("mast") ? 2 : 0);
            }
        });
        Stability stability = Worlds.start(project).getRobots().get(0).getStability();
        assertArrayEquals(new double[] {0, 0.4, 0}, stability.getCentre(), 1e-6);
        assertTrue(stability.getWords(), stability.getWords()
            .endsWith(". SEAR assumes its weight in the middle of its wheels until two of its shapes have a mass"));
    }

    /** It stands on a slope slightly below the angle and falls over on one slightly above. */
    @Test
    public void itTipsOverOnTheReportedSlope() throws Exception {
        for (double share : new double[] {0.85, 1.15}) {
            tower(1, 3, 0, 0.6);
            double told = Math.toDegrees(Math.atan2(0.15, 0.45 + RADIUS + HANGING));
            double slope = share * told;
            Floor floor = new Floor("floor", 20, 20);
            floor.rotate(0, 0, slope);
            SEARrobot robot = tower(1, 3, 0, 0.6);
            robot.rotate(0, 0, slope);
            Simulation simulation = Worlds.start(project);
            assertEquals(told, simulation.getRobots().get(0).getStability().degrees, 1e-3);
            Worlds.run(simulation, 4);
            double up = simulation.getPose("tower").rotate(0, 1, 0)[1];
            assertEquals("up after standing on " + slope + " degrees: " + up,
                share < 1, up > Math.cos(Math.toRadians(slope + 10)));
        }
    }

    @Test
    public void theSlopeIsReportedAtTheStart() throws Exception {
        new Floor("floor", 10, 10);
        tower(1, 3, 0, 0.9);
        assertEquals("[robot tower tips over to the left on a slope of 11 degrees, or when it brakes or turns with "
            + "more than 2.0 m/s\u00b2."
            + " Put weight lower or further inwards, or its wheels further apart]", Worlds.start(project)
                .snapshot().warnings.toString());
        assertEquals("a check says the same", Worlds.start(project).snapshot().warnings,
            ProjectCheck.warnings(Project.read(project.folder())));
        tower(1, 3, 0.3, 0.1);
        assertEquals(Worlds.start(project).snapshot().warnings, ProjectCheck.warnings(Project.read(project.folder())));
        Simulation simulation = Worlds.start(project);
        assertEquals("[robot tower falls over to the left at rest: its centre of mass at x 0.225, y 0.075, z 0.000 of "
            + "its frame is"
            + " 0.075 m outside its wheels. Put weight lower or further inwards, or its wheels further apart]",
            simulation.snapshot().warnings.toString());
        Worlds.run(simulation, 3);
        assertTrue("it lies on its side", simulation.getPose("tower").rotate(0, 1, 0)[1] < 0.9);
    }

    @Test
    public void templateRobotsCauseNoWarning() throws Exception {
        new Floor("floor", 10, 10);
        ProjectEditor editor = new ProjectEditor(project.folder());
        for (String template : RobotTemplates.names()) {
            if (template.equals("chassis")) {
                continue;    // ReadyRobotsTest covers its warning about missing wheels
            }
            editor.apply(Map.of("do", "robot", "template", template, "name", "robot"));
            assertEquals(template, List.of(), ProjectCheck.warnings(Project.read(project.folder())));
            editor.undo();
        }
    }

    /** A caster carries at its contact point, behind its axis. */
    @Test
    public void aCasterCarriesWhereItTouches() throws Exception {
        new Floor("floor", 10, 10);
        Robots.rover("rover");
        double[][] support = Worlds.start(project).getRobots().get(0).getStability().getSupport();
        assertEquals(3, support.length);
        assertEquals(-0.15, Math.min(support[0][2], Math.min(support[1][2], support[2][2])), 1e-9);
    }
}
