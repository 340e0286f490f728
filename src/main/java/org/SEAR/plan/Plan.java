// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plan;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.Pose;
import org.SEAR.robot.Robot;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.BeamFans;
import org.SEAR.simulator.Simulation;

/**
 * A world from above at one moment: objects with names, robots with headings, beams with their ends. Immutable; any
 * thread.
 */
public final class Plan {
    /** Maximum corners of a beam area. */
    private static final int MAX_BEAMS = 360;

    final List<Outline> outlines;
    final List<Mark> robots = new ArrayList<>();
    final List<Beams> beams = new ArrayList<>();
    /** Simulated seconds. */
    final double time;

    /** A robot: position, metres; heading, degrees clockwise from north; radius, metres. */
    static final class Mark {
        final String name;
        final double x;
        final double z;
        final double heading;
        final double radius;

        Mark(String name, Pose pose, double radius) {
            this.name = name;
            this.x = pose.x;
            this.z = pose.z;
            this.heading = pose.heading();
            this.radius = radius;
        }
    }

    /** Position of a sensor and the ends of its beams in order, {x, z}, metres. */
    static final class Beams {
        final double[] from;
        final List<double[]> ends = new ArrayList<>();
        /** Whether each beam ends on an object. */
        final List<Boolean> hits = new ArrayList<>();
        /** Whether the beams lie in one plane, which is drawn as an area. */
        final boolean plane;

        Beams(Pose sensor, boolean plane) {
            this.from = new double[] {sensor.x, sensor.z};
            this.plane = plane;
        }

        private void add(double[] end, boolean hit) {
            ends.add(new double[] {end[0], end[2]});
            hits.add(hit);
        }
    }

    private Plan(Simulation world) {
        outlines = Outline.of(world);
        time = world.getTime();
        for (Robot robot : world.getRobots()) {
            robots.add(new Mark(robot.getObject().getName(), robot.getPose(), robot.getHardware().getBodyRadius()));
        }
    }

    /**
     * Returns the plan of the current world. Simulation thread.
     *
     * @param withBeams whether to read beam sensors; readings do not change
     */
    public static Plan of(Simulation world, boolean withBeams) {
        Plan plan = new Plan(world);
        for (BeamFan fan : withBeams ? BeamFans.of(world.getProject()) : List.<BeamFan>of()) {
            plan.beams.add(beams(world, fan));
        }
        return plan;
    }

    /** Returns, for a plane, all beams or as many as can be distinguished; otherwise only beams that hit. */
    private static Beams beams(Simulation world, BeamFan fan) {
        Pose sensor = world.getRobots().get(fan.robot).getPose().times(world.getSensor(fan.sensor).getMount());
        double[] lengths = world.read(fan.sensor).beams();
        Beams beams = new Beams(sensor, fan.cut);
        int stride = 1 + (fan.size() - 1) / MAX_BEAMS;
        for (int i = 0; i < fan.size(); i++) {
            boolean hit = Double.isFinite(lengths[i]);
            if (fan.cut ? i % stride == 0 : hit) {
                double length = hit ? lengths[i] : fan.ranges[i];
                beams.add(sensor.transform(length * fan.directions[3 * i], length * fan.directions[3 * i + 1],
                    length * fan.directions[3 * i + 2]), hit);
            }
        }
        return beams;
    }
}
