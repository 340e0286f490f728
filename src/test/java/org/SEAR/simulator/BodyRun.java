// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;

/** A simulation with its bodies by name, for the scenes in org.SEAR.physics. */
public final class BodyRun implements AutoCloseable {
    private final Simulation simulation;
    private final Map<String, Body> bodies = new HashMap<>();

    /** Starts the world of a project. */
    public BodyRun(Path folder) throws ProjectException {
        simulation = Simulation.of(Project.read(folder), 1);
        simulation.getWorld().getPhysics().getBodies().forEach(body -> bodies.put(body.name, body));
    }

    /** Runs this many simulated seconds in whole steps. */
    public void run(double seconds) {
        Worlds.run(simulation, seconds);
    }

    public void step() {
        simulation.step();
    }

    /** Returns simulated time, seconds. */
    public double time() {
        return simulation.getTime();
    }

    public Pose pose(String name) {
        return simulation.getPose(name);
    }

    public Body body(String name) {
        return bodies.get(name);
    }

    /** Returns the number of awake bodies. */
    public int busy() {
        return simulation.getWorld().getPhysics().getBusyBodies();
    }

    /** Returns {vx, vy, vz, wx, wy, wz} of the centre of mass, world frame, m/s and rad/s. */
    public double[] velocities(String name) {
        double[] v = new double[6];
        body(name).velocities(v);
        return v;
    }

    /** Sets the velocities of a body immediately, world frame, m/s and rad/s. */
    public void set(String name, double vx, double vy, double vz, double wx, double wy, double wz) {
        body(name).setVelocities(vx, vy, vz, wx, wy, wz);
    }

    /** Teleports an object while the world runs, as an edit does. */
    public void move(String name, Pose to) {
        simulation.move(name, to, to);
    }

    /** Returns {position, speed, force of the motor} of a joint: degrees or metres. */
    public double[] joint(String name) {
        return simulation.getJoints().reading(name).numbers();
    }

    /** Returns {fx, fy, fz, tx, ty, tz} on a joint's second object, world frame. */
    public double[] jointForce(String name) {
        return simulation.getJoints().wrench(name);
    }

    /** Commands a motor. */
    public void order(ActuatorOrder.Kind kind, String name, double value) {
        simulation.order(new ActuatorOrder(kind, name, value));
    }

    /** Returns the warnings so far. */
    public String warnings() {
        return simulation.snapshot().warnings.toString();
    }

    @Override
    public void close() {
        simulation.close();
    }
}
