// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Servos have the same torque limit against contacts as against a load. */
public class ServoContactTest {
    private static final double GRAVITY = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static SEARrobot crane(double mass) {
        new Floor("floor", 10, 10);
        SEARrobot crane = new SEARrobot("crane");
        crane.addComponent(new Dynamics("weight", mass));
        crane.addComponent(Arm.box("base", 0.2, 0.2, 0.1, 2, 0, 0.05, 0));
        return crane;
    }

    private static List<String> messages(Simulation simulation) {
        return simulation.snapshot().warnings.stream().filter(text -> text.startsWith("servo "))
            .collect(Collectors.toList());
    }

    /**
     * Commanded to close completely, the fingers stop at the cube for any size and torque. The gripper lifts the cube,
     * and nothing tips over.
     */
    @Test
    public void aGripperHoldsItsObject() throws Exception {
        for (double size : new double[] {0.03, 0.05}) {
            for (double torque : new double[] {0.18, 2}) {
                SEARrobot crane = crane(3);
                Arm.box("table", 0.2, 0.2, 0.12 - size / 2, 0, 0, (0.12 - size / 2) / 2, 0.3);
                Arm.box("cube", size, size, size, 0.05, 0, 0.12, 0.25);
                Servo shoulder = Arm.on(crane, new Servo("shoulder", 0, 0.12, 0.05, 0, 0, -90), 60, 2,
                    Arm.box("arm", 0.02, 0.08, 0.02, 0.02, 0, 0.12, 0.12));
                for (int side : new int[] {1, -1}) {
                    Box finger = Arm.box("finger" + side, 0.01, 0.12, 0.02, 0.01, side * 0.05, 0.12, 0.21);
                    finger.setFriction(1);
                    shoulder.mount(Arm.on(crane, new Servo(side > 0 ? "left" : "right", side * 0.05, 0.12, 0.15), 400,
                        torque, finger));
                }
                try (Simulation simulation = Worlds.start(project)) {
                    Worlds.run(simulation, 0.5);
                    simulation.getServo("left").setAngle(-60);
                    simulation.getServo("right").setAngle(60);
                    Worlds.run(simulation, 1.5);
                    // where the finger's inner side meets the cube's far edge
                    double closed = Math.toDegrees(Math.atan((0.045 - size / 2) / (0.1 + size / 2)));
                    double angle = simulation.getServo("right").getAngle() - simulation.getServo("left").getAngle();
                    assertEquals(size + " m", 2 * closed, angle, 2);
                    assertEquals("the cube lies where it did", 0.25, simulation.getPose("cube").z, 0.005);
                    String told = String.join("\n", messages(simulation));
                    assertFalse(told, told.contains("is blocked"));
                    simulation.getServo("shoulder").setAngle(-30);
                    Worlds.run(simulation, 6);
                    Pose cube = simulation.getPose("cube");
                    assertEquals(size + " m, " + torque + " N m: " + cube, 0.12 + 0.2 * Math.sin(Math.toRadians(30)),
                        cube.y, 0.01);
                    double[] up = simulation.getPose("crane").rotate(0, 1, 0);
                    assertEquals("the crane stands upright", 1, up[1], 1e-4);
                }
            }
        }
    }

    /** A weight lying on an arm slows it like a mounted one: speed * (1 - moment / stall torque). */
    @Test
    public void anObjectLyingOnAnArmIsALoad() throws Exception {
        double mass = 0.05;
        double lever = 0.2;
        SEARrobot crane = crane(10);
        Arm.on(crane, new Servo("hinge", 0, 0.2, 0, 0, 0, -90), 60, 0.18,
            Arm.box("plank", 0.1, 0.3, 0.01, 0, 0, 0.2, 0.15));
        Box thing = Arm.box("thing", 0.04, 0.04, 0.04, mass, 0, 0.2251, lever);
        thing.setFriction(1);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        simulation.getServo("hinge").setAngle(-20);
        Worlds.run(simulation, 0.1);
        double from = simulation.getServo("hinge").getAngle();
        Worlds.run(simulation, 0.4);
        double expected = 60 * (1 - mass * GRAVITY * lever / 0.18) * 0.4;
        assertEquals(-expected, simulation.getServo("hinge").getAngle() - from, 0.1 * expected);
        assertEquals("it lies on the plank still", lever,
            Math.hypot(simulation.getPose("thing").z, simulation.getPose("thing").y - 0.2), 0.02);
    }

    /** An arm that can't push an obstacle stops there; neither the obstacle nor its robot moves away. */
    @Test
    public void aWeakArmStopsAtAHeavyObject() throws Exception {
        SEARrobot crane = crane(10);
        Arm.on(crane, new Servo("hinge", 0, 0.2, 0.1), 400, 0.18,
            Arm.box("stick", 0.02, 0.3, 0.02, 0.02, 0, 0.2, 0.25));
        Arm.box("block", 0.2, 0.2, 0.4, 40, 0.3, 0.2, 0.25);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        simulation.getServo("hinge").setAngle(90);
        Worlds.run(simulation, 5);
        double angle = simulation.getServo("hinge").getAngle();
        assertEquals("where the stick meets the block", Math.toDegrees(Math.atan2(0.2, 0.25)), angle, 12);
        assertEquals(0.3, simulation.getPose("block").x, 0.002);
        Pose crate = simulation.getPose("crane");
        assertEquals(0, Math.hypot(crate.x, crate.z), 0.002);
        Worlds.run(simulation, 5);
        assertEquals("and stays there", angle, simulation.getServo("hinge").getAngle(), 0.2);
        simulation.getServo("hinge").setAngle(0);
        Worlds.run(simulation, 1);
        assertEquals(0, simulation.getServo("hinge").getAngle(), 0);
    }

    /** Legs that push the ground reach their angles: the robot comes to rest without a warning about blocked servos. */
    @Test
    public void aRobotOnServoLegsComesToRest() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot bug = new SEARrobot("bug");
        bug.addComponent(new Dynamics("weight", 1));
        bug.addComponent(Arm.box("body", 0.12, 0.3, 0.06, 1, 0, 0.08, 0));
        List<String> hips = List.of("hip1", "hip2", "hip3", "hip4");
        for (int i = 0; i < hips.size(); i++) {
            double x = i % 2 == 0 ? 0.08 : -0.08;
            double z = i < 2 ? 0.12 : -0.12;
            Box leg = Arm.box("leg" + i, 0.02, 0.02, 0.1, 0.02, x, 0.05, z);
            leg.setFriction(1);
            Arm.on(bug, new Servo(hips.get(i), x, 0.09, z, 0, 0, -90), 200, 1, leg);
        }
        Simulation simulation = Worlds.start(project);
        for (double angle : new double[] {0, 30, -30, 0}) {
            hips.forEach(hip -> simulation.getServo(hip).setAngle(angle));
            Worlds.run(simulation, 1.5);
            hips.forEach(hip -> assertEquals(hip, angle, simulation.getServo(hip).getAngle(), 0.05));
        }
        assertEquals("bodies that move", 0, Worlds.physics(simulation).getBusyBodies());
        assertEquals(List.of(), messages(simulation));
    }
}
