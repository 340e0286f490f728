// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import static org.junit.Assert.assertEquals;

import java.nio.file.Path;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** A trailer follows its truck as the kinematics of rolling wheels says. */
public class TrailerTest {
    /** Rear axle of the truck behind its origin, and the trailer's axle behind the hitch, metres. */
    private static final double REAR = 0.15;
    private static final double LENGTH = 0.4;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** @param offset of the hitch behind the rear axle, metres; 0 for the example, whose hitch is at the axle */
    private Simulation truck(double offset) throws Exception {
        if (offset == 0) {
            return Simulation.of(Bundle.load(Path.of(System.getProperty("sear.root", "."), "examples/truck.sear"),
                project.folder()), 1);
        }
        new Floor("ground", 40, 40);
        SEARrobot truck = Robots.car("truck");
        SEARrobot trailer = new SEARrobot("trailer");
        trailer.move(0, 0.05, -REAR - offset - LENGTH);
        trailer.addComponent(new Dynamics("load", 2));
        trailer.addComponent(new Box("bed", 0.18, 0.4, 0.06, 2, 0, 0.05, 0.05));
        trailer.addWheel(new Wheel("leftTrailer", 0.05, 0.03, Wheel.FREE, 0.12, 0, 0));
        trailer.addWheel(new Wheel("rightTrailer", 0.05, 0.03, Wheel.FREE, -0.12, 0, 0));
        new BallJoint("hitch", truck, trailer, 0, 0.06, -REAR - offset);
        return Simulation.of(Project.read(project.folder()), 1);
    }

    private static void run(Simulation world, double seconds) {
        for (int i = 0; i < seconds * 60; i++) {
            world.step();
        }
    }

    /** Returns the radii of the middles of the rear axle and of the trailer's axle about the truck's instant centre. */
    private static double[] radii(Simulation world) {
        double[][] rear = new double[3][];
        double[] axle = null;
        for (int i = 0; i < 3; i++) {
            run(world, 1.5);
            rear[i] = world.getPose("truck").transform(0, 0, -REAR);
            axle = world.getPose("trailer").transform(0, 0, 0);
        }
        double[] centre = centre(rear);
        return new double[] {Math.hypot(rear[2][0] - centre[0], rear[2][2] - centre[1]),
            Math.hypot(axle[0] - centre[0], axle[2] - centre[1])};
    }

    /** Returns {x, z} of the circle through three points. */
    private static double[] centre(double[][] p) {
        double ax = p[1][0] - p[0][0];
        double az = p[1][2] - p[0][2];
        double bx = p[2][0] - p[0][0];
        double bz = p[2][2] - p[0][2];
        double d = 2 * (ax * bz - az * bx);
        double a = ax * ax + az * az;
        double b = bx * bx + bz * bz;
        return new double[] {p[0][0] + (bz * a - az * b) / d, p[0][2] + (ax * b - bx * a) / d};
    }

    /** Returns the angle between truck and trailer, radians. */
    private static double folded(Simulation world) {
        Pose truck = world.getPose("truck");
        Pose trailer = world.getPose("trailer");
        double[] along = truck.rotate(0, 0, 1);
        double[] behind = trailer.rotate(0, 0, 1);
        return Math.acos(Math.min(1, along[0] * behind[0] + along[1] * behind[1] + along[2] * behind[2]));
    }

    @Test
    public void theTrailerCutsTheCorner() throws Exception {
        for (double offset : new double[] {0, 0.08}) {
            try (Simulation world = truck(offset)) {
                world.post(DriveCommand.circle(0, 0.2, 1));
                run(world, 12);
                double[] radii = radii(world);
                double right = Math.sqrt(radii[0] * radii[0] + offset * offset - LENGTH * LENGTH);
                assertEquals("off-tracking", right, radii[1], 0.01 * right);
            }
        }
    }

    @Test
    public void itJackKnifesInReverse() throws Exception {
        try (Simulation world = truck(0)) {
            world.post(DriveCommand.wheels(0, 0.2, 0.2));
            world.order(new ActuatorOrder(ActuatorOrder.Kind.STEERING, "truck", 3));
            run(world, 4);
            world.order(new ActuatorOrder(ActuatorOrder.Kind.STEERING, "truck", 0));
            world.post(DriveCommand.wheels(0, -0.2, -0.2));
            run(world, 1);
            double before = folded(world);
            run(world, 3);
            double grown = Math.tan(folded(world) / 2) / Math.tan(before / 2);
            assertEquals("tan(angle / 2) grows by exp(way / length)", Math.exp(3 * 0.2 / LENGTH), grown, 0.05 * grown);
        }
    }
}
