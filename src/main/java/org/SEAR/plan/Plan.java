package org.SEAR.plan;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.Pose;
import org.SEAR.robot.Robot;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.BeamFans;
import org.SEAR.simulator.Simulation;

/** A world from above at one moment: things with their names, robots with their headings, beams up to what they meet. Immutable, any thread. */
public final class Plan {
    /** Corners of an area of beams. */
    private static final int MAX_BEAMS = 360;

    final List<Outline> outlines;
    final List<Mark> robots = new ArrayList<>();
    final List<Beams> beams = new ArrayList<>();
    /** Simulated seconds. */
    final double time;

    /** A robot: where it is, metres, how it looks, degrees clockwise from north, and how far it reaches, metres. */
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

    /** Where a sensor is and where its beams end, in their order, {x, z}, metres. */
    static final class Beams {
        final double[] from;
        final List<double[]> ends = new ArrayList<>();
        /** Whether each end is on something. */
        final List<Boolean> hits = new ArrayList<>();
        /** Whether the beams are a plane, which has an area. */
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
     * Of a world as it is now. Simulation thread.
     *
     * @param withBeams whether the sensors of beams are read, which changes no reading
     */
    public static Plan of(Simulation world, boolean withBeams) {
        Plan plan = new Plan(world);
        for (BeamFan fan : withBeams ? BeamFans.of(world.getProject()) : List.<BeamFan>of()) {
            plan.beams.add(beams(world, fan));
        }
        return plan;
    }

    /** Of a plane every beam, or so many as can be told apart; else those that have met something. */
    private static Beams beams(Simulation world, BeamFan fan) {
        Pose sensor = world.getRobots().get(fan.robot).getPose().times(world.getSensor(fan.sensor).getMount());
        double[] lengths = world.read(fan.sensor).beams();
        Beams beams = new Beams(sensor, fan.cut);
        int stride = 1 + (fan.size() - 1) / MAX_BEAMS;
        for (int i = 0; i < fan.size(); i++) {
            boolean hit = Double.isFinite(lengths[i]);
            if (fan.cut ? i % stride == 0 : hit) {
                double length = hit ? lengths[i] : fan.ranges[i];
                beams.add(sensor.transform(length * fan.directions[3 * i], length * fan.directions[3 * i + 1], length * fan.directions[3 * i + 2]),
                    hit);
            }
        }
        return beams;
    }
}
