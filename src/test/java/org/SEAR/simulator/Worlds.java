// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;

/** Robots and worlds that tests share. */
public final class Worlds {
    private Worlds() {
    }

    /** Returns the physics of a simulation, whose bodies only the simulation may move. */
    public static PhysicsWorld physics(Simulation of) {
        return of.getWorld().getPhysics();
    }

    /** Returns the scenes of a simulation's beams and wheels. */
    public static RaycastScenes scenes(Simulation of) {
        return of.getWorld().getScenes();
    }

    public static Body body(Simulation of, String name) {
        return physics(of).getBodies().stream().filter(body -> body.name.equals(name)).findFirst().orElseThrow();
    }

    /** Makes the robot of the dissertation's Listing 2, upright. */
    public static SEARrobot roomba(String name, double x, double z, double heading) {
        return roomba(name, 400, x, z, heading);
    }

    /** Makes the robot with another mass, kg. Contacts with much lighter bodies need many solver iterations. */
    public static SEARrobot roomba(String name, double mass, double x, double z, double heading) {
        SEARrobot robot = new SEARrobot(name);
        robot.addComponent(new Dynamics(name + "Dynamics", mass, 60, 0.3, 0.4, 10000, 0.1, x, 0.1, z, 0, heading, 0));
        robot.addComponent(new Cylinder(name + "Body", 0.1666875, 0.0762, mass));
        robot.addWheel(new Wheel(name + "Front", 0.0381, 0.03, 0, 0, 0, 0.16));
        robot.addWheel(new Wheel(name + "Right", 0.0381, 0.03, 1, -0.16, 0, 0));
        robot.addWheel(new Wheel(name + "Left", 0.0381, 0.03, 1, 0.16, 0, 0));
        robot.addWheel(new Wheel(name + "Back", 0.0381, 0.03, 0, 0, 0, -0.16));
        return robot;
    }

    /**
     * Makes a box-shaped robot with wheels at (+-halfTrack, 0, z) and an idler at (0, 0, idlerZ) unless idlerZ is 0.
     */
    public static SEARrobot cart(String name, double mass, double radius, double halfTrack, double[] axles,
        double idlerZ, double x, double z, double heading) {
        SEARrobot robot = new SEARrobot(name);
        robot.addComponent(new Dynamics(name + "Dynamics", mass, 60, 0.3, 0.4, 10000, radius, x, 2 * radius, z, 0,
            heading, 0));
        Box body = new Box(name + "Body", 1.6 * halfTrack, 3 * halfTrack, radius, 0);
        body.move(0, radius, 0);
        robot.addComponent(body);
        for (int i = 0; i < axles.length; i++) {
            robot.addWheel(new Wheel(name + "Left" + i, radius, radius / 2, 1, halfTrack, 0, axles[i]));
            robot.addWheel(new Wheel(name + "Right" + i, radius, radius / 2, 1, -halfTrack, 0, axles[i]));
        }
        if (idlerZ != 0) {
            robot.addWheel(new Wheel(name + "Idler", radius, radius / 2, 0, 0, 0, idlerZ));
        }
        return robot;
    }

    public static Simulation start(ProjectRule project) throws ProjectException {
        return Simulation.of(Project.read(project.folder()), 1);
    }

    public static void run(Simulation simulation, double seconds) {
        long steps = Math.round(seconds / Simulation.STEP);
        for (long i = 0; i < steps; i++) {
            simulation.step();
        }
    }
}
