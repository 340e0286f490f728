// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.function.Function;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** The start warns about legal but probably unintended values, and about nothing else. */
public class StartWarningsTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private List<String> warnings() throws Exception {
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            return world.snapshot().warnings;
        }
    }

    private void assertTold(String... words) throws Exception {
        List<String> told = warnings();
        assertEquals(told.toString(), 1, told.size());
        for (String word : words) {
            assertTrue(told.toString(), told.get(0).contains(word));
        }
    }

    /** Makes a robot with its own spring rate on three wheels. */
    private static SEARrobot threeWheels(double leftY, double rightY, double casterY) {
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 2, 1000, 0.5, 0.5, 10000, 0.02, 0, 0.15, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.2, 0.1, 0.3, 1));
        robot.addWheel(new Wheel("left", 0.05, 0.03, 1, 0.12, leftY, 0.1));
        robot.addWheel(new Wheel("right", 0.05, 0.03, 1, -0.12, rightY, 0.1));
        robot.addWheel(new Wheel("caster", 0.05, 0.02, 0, 0, casterY, -0.15));
        return robot;
    }

    @Test
    public void readyRobotsAreNotWarnedOf() throws Exception {
        new Floor("floor", 20, 20);
        double z = 0;
        for (Function<String, SEARrobot> maker : List.<Function<String, SEARrobot>>of(
            Robots::rover, Robots::fourWheeled, Robots::car, Robots::create, Robots::create2, Robots::roomba400)) {
            maker.apply("robot" + (int) z).move(0, 0, z++);
        }
        assertEquals(List.of(), warnings());
    }

    @Test
    public void aTiltedRobotIsReportedWithItsDirection() throws Exception {
        new Floor("floor", 20, 20);
        threeWheels(0, 0, 0.03);
        assertTold("robot robot stands tilted by 7 degrees, with its front up", "caster to y -0.020 m",
            "should be the same for all");
    }

    @Test
    public void tiltedBackwardsAndToTheSide() throws Exception {
        new Floor("floor", 20, 20);
        threeWheels(0, 0, -0.03);
        assertTold("stands tilted by 7 degrees, with its back up");
        threeWheels(-0.02, 0.02, 0);
        assertTrue(warnings().toString(), warnings().toString()
            .contains("stands tilted by 9 degrees, with its left up"));
        threeWheels(0, 0, 0.005);
        assertEquals(List.of(), warnings());
    }

    @Test
    public void modelsInCentimetresOrMillimetresAreReported() throws Exception {
        new Box("crate", 40, 30, 30, 2).move(0, 15, 0);
        assertTold("crate is 40 m large and weighs 2 kg", "lighter than air", "in centimetres, it is 0.400 m",
            "by 100, or call scale(0.01) on a model");
        new Box("crate", 400, 300, 300, 2).move(0, 150, 0);
        assertTold("drawn in millimetres, it is 0.400 m", "scale(0.001)");
        new Floor("floor", 20, 20);
        assertTold("drawn in millimetres, it is 0.400 m");
        new Box("crate", 400, 300, 300, 0).move(100, 150, 0);
        new Box("crate", 1.5, 1.5, 1.5, 0.2).move(0, 0.75, 0);
        assertEquals(List.of(), warnings());
    }

    @Test
    public void aRobotAndAModelThatWereDrawnInMillimetres() throws Exception {
        SEARrobot robot = threeWheels(0, 0, 0);
        robot.addComponent(new Box("shell", 200, 100, 300, 0));
        assertTrue(warnings().toString(), warnings().get(0).contains("robot robot is "));
        project.put("assets/hall.obj", "v 0 0 0\nv 12000 0 0\nv 0 3000 0\nf 1 2 3\n");
        new Model("hall", "hall.obj").move(20000, 0, 0);
        assertTrue(warnings().toString(), warnings().toString()
            .contains("model hall is 12000 m large. Lengths are in metres: if it was drawn in"));
        new Model("hall", "hall.obj").setTerrain(true);
        assertTrue(warnings().toString(), !warnings().toString().contains("model hall is"));
    }

    private void putCubes(String name, int... atX) throws Exception {
        StringBuilder text = new StringBuilder();
        for (int x : atX) {
            for (int i = 0; i < 8; i++) {
                text.append("v " + (x + i % 2) + " " + i / 2 % 2 + " " + i / 4 + "\n");
            }
            text.append("f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n");
        }
        project.put("assets/" + name, text.toString());
    }

    @Test
    public void aMovableModelWithHollowsIsReportedWithTheRatioOfVolumes() throws Exception {
        new Floor("floor", 20, 20);
        putCubes("pair.obj", 0, 3);
        Model pair = new Model("pair", "pair.obj");
        assertEquals(List.of(), warnings());
        pair.setMass(100);
        assertTold("contacts of a model of pair use its convex hull, which has 2.0 times the volume inside "
            + "its triangles", "setCollision(\"parts\")");
        pair.setCollision("parts");
        assertEquals(List.of(), warnings());
        pair.setCollision(null);
        putCubes("pair.obj", 0, 1);
        assertEquals(List.of(), warnings());
        project.put("assets/pair.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 4\nf 1 4 3\n");
        assertEquals(List.of(), warnings());
    }

    @Test
    public void drivenWheelsOnOneSideOnly() throws Exception {
        new Floor("floor", 20, 20);
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 2, 0, 0.2, 0, 0, 0, 0));
        robot.addWheel(new Wheel("front", 0.05, 0.03, 1, -0.12, 0, 0.1));
        robot.addWheel(new Wheel("back", 0.05, 0.03, 1, -0.12, 0, -0.1));
        robot.addWheel(new Wheel("caster", 0.05, 0.02, 0, 0.12, 0, 0));
        assertTold("robot robot has all its driven wheels on the right (front, x -0.12 m)",
            "wheel.move(0.12, 0, 0.1) puts one on the other side");
    }

    @Test
    public void centimetresForMetres() throws Exception {
        new Floor("floor", 20, 20);
        new Box("near", 1, 1, 1).move(0, 0.5, 55);
        assertEquals(List.of(), warnings());
        new Box("wall", 1, 1, 1).move(150, 0.5, 0);
        assertTold("wall starts 140 m beside the ground, at x 150, z 0", "use x 1.50, z 0");
        new Box("wall", 400, 1, 10).move(0, 0.5, 0);
        assertTold("wall is 400 m large, but the ground only 20 m", "divide them by 100");
        new Box("wall", 1, 1, 1, 1).move(0, 90, 0);
        assertTold("wall starts 90 m above the ground and will fall. Lengths are in metres");
    }

    @Test
    public void objectsBesideNoGroundAreNotReported() throws Exception {
        new Box("wall", 1, 1, 1).move(150, 0.5, 0);
        assertEquals(List.of(), warnings());
    }

    @Test
    public void weakMotors() throws Exception {
        new Floor("floor", 20, 20);
        SEARrobot rover = threeWheels(0, 0, 0);
        rover.addComponent(new Motor("leftMotor", rover.getWheels().get(0), 0.0005, 20));
        rover.addComponent(new Motor("rightMotor", rover.getWheels().get(1), 0.0005, 20));
        assertTold("robot robot weighs 2 kg, but its motors push it with only 0.020 N in all: it needs 10 s to "
            + "reach 0.1 m/s", "stallTorque of leftMotor, now 0.0005 N m");
    }

    @Test
    public void anObjectThatOverlapsARobotAtTheStartIsNamed() throws Exception {
        new Floor("floor", 20, 20);
        new Box("wall", 1, 1, 1).move(0, 0.5, 0);
        Robots.rover("rover");
        assertTold("rover started inside a fixed object (wall); SEAR moved it by (0.000, 0.000, -0.560) m, the "
            + "shortest way out");
    }
}
