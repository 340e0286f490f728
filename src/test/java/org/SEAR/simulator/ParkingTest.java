package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** A vehicle that nobody drives stands on a slope that its tyres can hold, whichever way it looks, and slides down one that they can't. */
public class ParkingTest {
    private static final double SLOPE = 15;
    private static final double MILLIMETRE = 1e-3;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** A ready robot on a slope that falls to the south, looking somewhere. */
    private SEARrobot parked(String kind, double heading, double slope) {
        new Floor("floor", 200, 200).rotate(0, 0, slope);
        SEARrobot robot = kind.equals("car") ? Robots.car("robot") : kind.equals("rover") ? Robots.rover("robot")
            : kind.equals("four") ? Robots.fourWheeled("robot") : Robots.create("robot", "/dev/uart", "/dev/user");
        robot.rotate(0, heading, slope);
        robot.move(0, 0, 0);
        return robot;
    }

    private void stands(String kind, double heading) throws Exception {
        parked(kind, heading, SLOPE);
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 2);
            Pose from = simulation.getPose("robot");
            Worlds.run(simulation, 60);
            Pose to = simulation.getPose("robot");
            String what = kind + " looking to " + heading;
            double way = Math.sqrt(Math.pow(to.x - from.x, 2) + Math.pow(to.y - from.y, 2) + Math.pow(to.z - from.z, 2));
            assertEquals(what, 0, way, MILLIMETRE);
            double cosine = Math.abs(from.qx * to.qx + from.qy * to.qy + from.qz * to.qz + from.qw * to.qw);
            assertEquals(what + " turned, degrees", 0, Math.toDegrees(2 * Math.acos(Math.min(1, cosine))), 0.1);
            System.out.println("PARK " + what + " " + way*1000 + " mm up=" + java.util.Arrays.toString(to.rotate(0, 1, 0))+ " "+to);
        }
    }

    @Test
    public void itStandsWhicheverWayItLooks() throws Exception {
        for (String kind : new String[] {"car", "rover", "four", "create"}) {
            for (double heading : new double[] {0, 30, 90, 135, 180, -60}) {
                stands(kind, heading);
            }
        }
    }
}
