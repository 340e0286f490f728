// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.Map;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Slider;
import org.SEAR.devices.MotorHardware;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Motors with gears on joints of a robot, against the line of a DC motor. */
public class JointMotorTest {
    private static final double GRAVITY = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static SEARrobot tower() {
        SEARrobot robot = new SEARrobot("tower");
        robot.addComponent(new Dynamics("dynamics", 12));
        robot.addComponent(new Box("mast", 0.2, 0.2, 2, 9, 0, 1, -1, 0, 0, 0));
        new FixedJoint("bolt", null, robot);
        return robot;
    }

    /** 0.1 N m and 50 rad/s by 200 rad/m: 20 N, 0.25 m/s. */
    private static Motor lift(SEARrobot robot, double mass) {
        Box cabin = new Box("cabin", 0.2, 0.2, 0.2, mass, 0, 1, 0, 0, 0, 0);
        robot.addComponent(cabin);
        Slider rail = new Slider("rail", null, cabin, 0, 1, 0);
        robot.addComponent(rail);
        Motor motor = new Motor("lift", rail, 0.1, 50, 200, 12);
        robot.addComponent(motor);
        return motor;
    }

    @Test
    public void itsSpeedUnderLoadIsOnItsLine() throws Exception {
        lift(tower(), 1);
        try (Simulation world = Worlds.start(project)) {
            MotorHardware motor = world.getMotor("lift");
            Worlds.run(world, 1);
            double sinks = -0.25 * GRAVITY / 20;
            assertEquals("without power it brakes", sinks, motor.getSpeed(), 0.01 * -sinks);
            motor.setPower(1);
            Worlds.run(world, 1);
            double rises = 0.25 * (1 - GRAVITY / 20);
            assertEquals(rises, motor.getSpeed(), 0.01 * rises);
            assertEquals(GRAVITY / 20, motor.getLoad(), 0.005);
            long counts = motor.getCounts();
            Worlds.run(world, 1);
            assertEquals("turns of the shaft times 12", rises * 200 / (2 * Math.PI) * 12,
                motor.getCounts() - counts, 4);
            motor.setSpeed(0.1);
            Worlds.run(world, 1);
            assertEquals(0.1, motor.getSpeed(), 1e-4);
            assertEquals(0.1, world.getJoints().reading("rail").numbers()[1], 1e-4);
            String said = assertThrows(IllegalArgumentException.class, () -> motor.setSpeed(0.3)).getMessage();
            assertEquals("motor lift of robot tower: speed is 0.3, legal: -0.25 to 0.25 rad/s, m/s of a slider or "
                + "rope, which its joint reaches without load", said);
        }
    }

    @Test
    public void aHingeTurnsWithItsMotorAndReactsOnTheRobot() throws Exception {
        SEARrobot robot = tower();
        Box disc = new Box("disc", 0.4, 0.4, 0.02, 1, 0, 1, 0, 0, 0, 0);
        robot.addComponent(disc);
        Hinge hub = new Hinge("hub", null, disc, 0, 1, 0);
        robot.addComponent(hub);
        robot.addComponent(new Motor("spindle", hub));
        Arduino uno = new Arduino("uno");
        robot.addComponent(uno);
        uno.wire(9, "spindle", "pwm");
        try (Simulation world = Worlds.start(project)) {
            world.getMotor("spindle").setPower(0.5);
            Worlds.run(world, 0.1);
            double[] torque = world.getJoints().wrench("hub");
            double inertia = 2 * 0.4 * 0.4 / 12;
            double fastest = 0.5 * 20;
            double rate = 0.5 / 20 / inertia;
            assertEquals("I w' = M (p - w / w0)", fastest * (1 - Math.exp(-rate * 0.1)),
                world.getMotor("spindle").getSpeed(), 0.01 * fastest);
            assertTrue(torque[4] > 0);
            Worlds.run(world, 20);
            assertEquals(fastest, world.getMotor("spindle").getSpeed(), 0.01);
        }
    }

    @Test
    public void wrongJointsAreReported() throws Exception {
        SEARrobot robot = tower();
        Motor motor = lift(robot, 1);
        Project.read(project.folder());
        robot.addComponent(new Motor("second", (Slider) robot.getPart("rail")));
        problem("joint is \"rail\", legal: a joint that nothing drives yet; robot/lift.xml drives it");
        ((Motor) robot.getPart("second")).set(Map.of("joint", "mast"));
        problem("joint is \"mast\", legal: the name of a hinge, slider or rope of the motor's robot tower");
        ((Slider) robot.getPart("rail")).setMotor(1, 1);
        problem("joint is \"rail\", legal: a joint that nothing drives yet; this one has a motor of its own, by "
            + "setMotor");
        String said = assertThrows(IllegalArgumentException.class, () -> new Motor("third", (Slider) null))
            .getMessage();
        assertEquals("Motor \"third\": joint is missing (None), legal: a hinge, slider or rope of the same robot, or a "
            + "driven wheel (type 1)", said);
        assertEquals("rail", motor.getJoint());
    }

    private void problem(String words) {
        String said = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains(words));
    }
}
