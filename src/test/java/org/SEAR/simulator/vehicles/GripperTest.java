// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Slider;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.ProjectSwap;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A gantry of sliders with two fingers, which a motor closes by a gear. */
public class GripperTest {
    private static final double GRAVITY = 9.81;
    /** Force of both fingers together, N. */
    private static final double FORCE = 20;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static Slider slide(SEARrobot robot, String name, Shape first, Shape second, double force, double rz) {
        Slider slider = new Slider(name, first, second, second.getX(), second.getY(), second.getZ(), 0, 0, rz);
        if (force > 0) {
            slider.setMotor(force, 0.1);
        }
        robot.addComponent(slider);
        return slider;
    }

    private static Box part(SEARrobot robot, String name, double width, double height, double x, double y) {
        Box part = new Box(name, width, 0.06, height, 0.2, x, y, 0, 0, 0, 0);
        robot.addComponent(part);
        return part;
    }

    /** Makes the gantry above the origin, its fingers 9 cm apart. */
    private static SEARrobot gantry() {
        SEARrobot robot = new SEARrobot("gantry");
        robot.addComponent(new Dynamics("dynamics", 10));
        robot.addComponent(new Box("beam", 1, 0.05, 0.05, 9, 0, 0.6, 0, 0, 0, 0));
        new FixedJoint("bolt", null, robot, 0, 0.6, 0);
        Box carriage = part(robot, "carriage", 0.1, 0.05, 0, 0.5);
        Box palm = part(robot, "palm", 0.12, 0.02, 0, 0.16);
        Box left = part(robot, "left", 0.01, 0.06, -0.05, 0.035);
        Box right = part(robot, "right", 0.01, 0.06, 0.05, 0.035);
        left.setFriction(0.9);
        right.setFriction(0.9);
        slide(robot, "across", null, carriage, 100, -90);
        slide(robot, "up", carriage, palm, 100, 0);
        Slider finger = slide(robot, "finger", palm, left, FORCE, -90);
        finger.setLimits(0, 0.045);
        slide(robot, "other", palm, right, 0, -90).setGear(finger, -1);
        return robot;
    }

    private static void drive(Simulation world, String joint, double to) {
        world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, joint, to));
        Worlds.run(world, 4);
    }

    private static <T extends Shape> Supplier<T> at(double y, double rx, double ry, double rz, Supplier<T> shape) {
        return () -> {
            T made = shape.get();
            made.move(0, y, 0);
            made.rotate(rx, ry, rz);
            return made;
        };
    }

    private static Map<String, Supplier<? extends Shape>> shapes() {
        Map<String, Supplier<? extends Shape>> all = new LinkedHashMap<>();
        all.put("cube", at(0.03, 0, 0, 0, () -> new Box("thing", 0.06, 0.06, 0.06, 0.1)));
        all.put("plate", at(0.01, 0, 0, 0, () -> new Box("thing", 0.06, 0.06, 0.02, 0.1)));
        all.put("post", at(0.06, 0, 0, 0, () -> new Box("thing", 0.05, 0.05, 0.12, 0.1)));
        all.put("cube by its edges", at(0.025, 0, 45, 0, () -> new Box("thing", 0.05, 0.05, 0.05, 0.1)));
        all.put("can", at(0.04, 0, 0, 0, () -> new Cylinder("thing", 0.03, 0.08, 0.1)));
        all.put("disc", at(0.01, 0, 0, 0, () -> new Cylinder("thing", 0.03, 0.02, 0.1)));
        all.put("lying can", at(0.03, 90, 0, 0, () -> new Cylinder("thing", 0.03, 0.08, 0.1)));
        all.put("lying can by its ends", at(0.03, 0, 0, 90, () -> new Cylinder("thing", 0.03, 0.07, 0.1)));
        all.put("ball", at(0.03, 0, 0, 0, () -> new Sphere("thing", 0.03, 0.1)));
        all.put("bar", at(0.015, 0, 0, 0, () -> new Box("thing", 0.04, 0.3, 0.03, 0.1)));
        return all;
    }

    @Test
    public void itLiftsCarriesAndSetsDownTenShapes() throws Exception {
        Map<String, Supplier<? extends Shape>> shapes = shapes();
        assertEquals(10, shapes.size());
        for (Map.Entry<String, Supplier<? extends Shape>> one : shapes.entrySet()) {
            ProjectSwap.delete(project.folder());
            new Floor("floor", 4, 4);
            gantry();
            one.getValue().get();
            try (Simulation world = Worlds.start(project)) {
                Pose start = world.getPose("thing");
                drive(world, "finger", 0.045);
                drive(world, "up", 0.15);
                assertEquals(one.getKey() + " is up", start.y + 0.15, world.getPose("thing").y, 2e-3);
                drive(world, "across", 0.3);
                assertEquals(one.getKey() + " is over there", 0.3, world.getPose("thing").x, 2e-3);
                drive(world, "up", 0);
                drive(world, "finger", 0);
                Pose end = world.getPose("thing");
                assertEquals(one.getKey() + " is down", start.y, end.y, 1e-3);
                assertEquals(one.getKey(), 0.3, end.x, 3e-3);
                double[] was = start.rotate(0, 1, 0);
                double[] is = end.rotate(0, 1, 0);
                boolean ball = one.getKey().equals("ball");
                assertEquals(one.getKey() + " stands as before", 1, ball ? 1 : was[0] * is[0] + was[1] * is[1]
                    + was[2] * is[2], 1e-3);
            }
        }
    }

    @Test
    public void itSlipsBeyondItsFriction() throws Exception {
        assertTrue(slip(0.97) < 1e-4);
        assertTrue(slip(1.03) > 0.02);
    }

    /** Returns how far a box slides down between the fingers when its support goes away, metres. */
    private double slip(double share) throws Exception {
        ProjectSwap.delete(project.folder());
        SEARrobot robot = gantry();
        ((Box) robot.getPart("left")).setFriction(0.5);
        ((Box) robot.getPart("right")).setFriction(0.5);
        double mass = share * FORCE * 0.5 * 0.8 / GRAVITY;
        Box thing = new Box("thing", 0.06, 0.06, 0.06, mass, 0, 0.03, 0, 0, 0, 0);
        thing.setFriction(0.8);
        Box table = new Box("table", 0.06, 0.06, 0.1, 1, 0, -0.05, 0, 0, 0, 0);
        new Slider("lowers", null, table, 0, -0.05, 0).setMotor(1000, 0.5);
        try (Simulation world = Worlds.start(project)) {
            drive(world, "finger", 0.045);
            double before = world.getPose("thing").y;
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, "lowers", -0.3));
            Worlds.run(world, 0.5);
            return before - world.getPose("thing").y;
        }
    }
}
