// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.ContactForce;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Slider;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Weights and pushes on a part of a robot, against closed forms. */
public class ContactForceTest {
    private static final double G = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Makes a robot that the world holds, with a plate at a height of 1 m and its sensor. */
    private static SEARrobot scale() {
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("dynamics", 20));
        Box plate = new Box("plate", 1, 1, 0.1, 10, 0, 0.95, 0, 0, 0, 0);
        robot.addComponent(plate);
        robot.addComponent(new Box("foot", 0.1, 0.1, 0.1, 10, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new ContactForce("scale", plate));
        robot.addComponent(new ContactForce("all"));
        new FixedJoint("bolt", null, robot);
        return robot;
    }

    private static double read(Simulation world, String name) {
        return world.read(name).numbers()[0];
    }

    @Test
    public void aBoxPressesWithItsWeight() throws Exception {
        scale();
        new Box("load", 0.2, 0.2, 0.2, 2, 0.1, 1.1, 0, 0, 0, 0);
        new Box("more", 0.1, 0.1, 0.1, 0.5, 0.1, 1.25, 0, 0, 0, 0);
        try (Simulation world = Worlds.start(project)) {
            assertEquals("before the first step", 0, read(world, "scale"), 0);
            Worlds.run(world, 0.5);
            assertEquals(2.5 * G, read(world, "scale"), 0.01 * 2.5 * G);
            assertEquals(read(world, "scale"), read(world, "all"), 0);
            Worlds.run(world, 5);
            assertEquals("asleep", 2.5 * G, read(world, "scale"), 0.01 * 2.5 * G);
            assertEquals("N", world.getUnit("scale"));
            assertTrue(world.read("scale").words("N").endsWith(" N"));
        }
    }

    @Test
    public void aPushOfAMotorIsItsForce() throws Exception {
        scale();
        Box ram = new Box("ram", 0.1, 0.1, 0.1, 1, -0.6, 0.95, 0, 0, 0, 0);
        Slider push = new Slider("push", null, ram, -0.6, 0.95, 0, 0, 0, -90);
        push.setMotor(7, 0.5);
        try (Simulation world = Worlds.start(project)) {
            assertEquals(0, read(world, "scale"), 0);
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, "push", 0.5));
            Worlds.run(world, 1);
            assertEquals(7, read(world, "scale"), 0.05);
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, "push", -0.3));
            Worlds.run(world, 1);
            assertEquals("it is away", 0, read(world, "scale"), 0);
        }
    }

    /** The impulse of a fall from 20 cm, 0.5 kg sqrt(2 g h), and that of its weight in this step. */
    @Test
    public void anImpactHasItsImpulse() throws Exception {
        scale();
        new Box("stone", 0.1, 0.1, 0.1, 0.5, 0, 1.25, 0, 0, 0, 0);
        try (Simulation world = Worlds.start(project)) {
            double sum = 0;
            for (int i = 0; i < 60; i++) {
                world.step();
                sum += read(world, "scale") * Simulation.STEP;
            }
            assertEquals("momentum", 0.5 * G * 60 * Simulation.STEP, sum, 0.01 * sum);
        }
    }

    @Test
    public void aPartOnAJointHasItsOwnForce() throws Exception {
        SEARrobot robot = scale();
        Box lid = new Box("lid", 0.2, 0.2, 0.02, 0.1, 0, 1.5, 0, 0, 0, 0);
        robot.addComponent(lid);
        robot.addComponent(new ContactForce("onLid", lid));
        Hinge hinge = new Hinge("hinge", null, lid, 0, 1.5, 0);
        robot.addComponent(hinge);
        new Box("load", 0.1, 0.1, 0.1, 1, 0, 1.56, 0, 0, 0, 0);
        try (Simulation world = Worlds.start(project)) {
            Worlds.run(world, 1);
            assertEquals(G, read(world, "onLid"), 0.01 * G);
            assertEquals(0, read(world, "scale"), 0);
            assertEquals(read(world, "onLid"), read(world, "all"), 0);
        }
    }

    @Test
    public void aWheelCanNotPressIt() throws Exception {
        String said = assertThrows(IllegalArgumentException.class,
            () -> new ContactForce("touch", new Wheel("left", 0.05, 0.02, 1))).getMessage();
        assertEquals("ContactForce \"touch\": Wheel \"left\" can't press it, legal: a shape that is a component of the "
            + "same robot, and no wheel; ContactForce(name) is pressed by each of them", said);
        SEARrobot robot = scale();
        robot.addComponent(new ContactForce("stranger", new Box("elsewhere", 1, 1, 1)));
        said = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("part is \"elsewhere\", legal: the name of a shape of the sensor's robot robot: "
            + "plate, foot"));
    }
}
