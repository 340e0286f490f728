// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A parked vehicle stands in any heading on a slope within its tyres' grip and slides down a steeper one. */
public class ParkingTest {
    private static final double SLOPE = 15;
    private static final double MILLIMETRE = 1e-3;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Places a ready-made robot with a heading on a slope that falls to one side. */
    private SEARrobot parked(String kind, double heading, double slope) {
        new Floor("floor", 200, 200).rotate(0, 0, slope);
        SEARrobot robot = kind.equals("car") ? Robots.car("robot") : kind.equals("rover") ? Robots.rover("robot")
            : kind.equals("four") ? Robots.fourWheeled("robot") : Robots.create("robot", "/dev/uart", "/dev/user");
        Pose leaning = Pose.ofDegrees(0, 0, 0, 0, 0, slope).times(Pose.ofDegrees(0, 0, 0, 0, heading, 0));
        double[] ahead = leaning.rotate(0, 0, 1);
        robot.rotate(-Math.toDegrees(Math.asin(ahead[1])), Math.toDegrees(Math.atan2(ahead[0], ahead[2])),
            Math.toDegrees(Math.atan2(leaning.rotate(1, 0, 0)[1], leaning.rotate(0, 1, 0)[1])));
        return robot;
    }

    private static double way(Pose from, Pose to) {
        return Math.sqrt(Math.pow(to.x - from.x, 2) + Math.pow(to.y - from.y, 2) + Math.pow(to.z - from.z, 2));
    }

    private void stands(String kind, double heading) throws Exception {
        parked(kind, heading, SLOPE);
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 2);
            Pose from = simulation.getPose("robot");
            Worlds.run(simulation, 60);
            Pose to = simulation.getPose("robot");
            String what = kind + " looking to " + heading;
            assertEquals(what, 0, way(from, to), MILLIMETRE);
            double cosine = Math.abs(from.qx * to.qx + from.qy * to.qy + from.qz * to.qz + from.qw * to.qw);
            assertEquals(what + " turned, degrees", 0, Math.toDegrees(2 * Math.acos(Math.min(1, cosine))), 0.1);
        }
    }

    @Test
    public void itStandsWhicheverWayItLooks() throws Exception {
        for (String kind : new String[] {"car", "rover", "four", "create"}) {
            for (double heading : new double[] {0, 30, 90, 135, -60}) {
                stands(kind, heading);
            }
        }
    }

    /**
     * Across the slope it stands while the friction f exceeds the slope's tangent, and otherwise slides with g (sin - f
     * cos).
     */
    @Test
    public void itSlidesWhereItsTyresDoNotHold() throws Exception {
        double slope = Math.toRadians(SLOPE);
        for (double friction : new double[] {0.32, 0.1}) {
            SEARrobot robot = parked("car", 0, SLOPE);
            robot.getWheels().forEach(wheel -> wheel.setFriction(friction / 0.8));
            try (Simulation simulation = Worlds.start(project)) {
                Worlds.run(simulation, 0.5);
                Pose from = simulation.getPose("robot");
                double speed = simulation.snapshot().robots.get(0).speed;
                Worlds.run(simulation, 1);
                double way = way(from, simulation.getPose("robot"));
                double pull = 9.81 * (Math.sin(slope) - friction * Math.cos(slope));
                assertTrue("speed ahead " + speed, Math.abs(speed) < 0.05);
                assertEquals("friction " + friction, pull > 0 ? pull * (0.5 * 1 + 0.5) : 0, way, pull > 0 ? 0.1 * pull
                    : MILLIMETRE);
            }
        }
    }
}
