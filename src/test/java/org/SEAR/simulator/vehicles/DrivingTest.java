// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.devices.RobotHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Robots of many kinds follow commanded motion. */
public class DrivingTest {
    private static final double FULL_TURN = 2 * Math.PI;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void theDissertationsRoombaMeetsItsCommands() throws Exception {
        Worlds.roomba("roomba", 0, 0, 0);
        meetsCommands(0.2);
    }

    @Test
    public void twoWheelsAndACasterMeetTheirCommands() throws Exception {
        Worlds.cart("cart", 1, 0.02, 0.06, new double[] {0}, 0.1, 0, 0, 0);
        meetsCommands(0.1);
    }

    @Test
    public void twoWheelsAndACasterBehindMeetTheirCommands() throws Exception {
        Worlds.cart("cart", 20, 0.1, 0.25, new double[] {0}, -0.3, 0, 0, 0);
        meetsCommands(0.3);
    }

    @Test
    public void fourDrivenWheelsMeetTheirCommands() throws Exception {
        Worlds.cart("skid", 40, 0.1, 0.2, new double[] {0.2, -0.2}, 0, 0, 0, 0);
        meetsCommands(0.3);
    }

    @Test
    public void aHeavyRobotWithLargeWheelsMeetsItsCommands() throws Exception {
        Worlds.cart("truck", 400, 0.3, 0.6, new double[] {0.5, -0.5}, 0, 0, 0, 0);
        meetsCommands(0.5);
    }

    @Test
    public void readyRobotsMeetTheirCommandsOnTheWheelsOfTheRealOnes() throws Exception {
        Robots.roomba400("r");
        assertEquals(0.258, meetsCommands(0.3).getTrack(), 1e-9);
        Robots.create("r", "/dev/uart", "/dev/user");
        assertEquals(0.258, meetsCommands(0.4).getTrack(), 1e-9);
        Robots.create2("r", "/dev/uart", "/dev/user");
        RobotHardware create2 = meetsCommands(0.2);
        assertEquals(0.235, create2.getTrack(), 1e-9);
        assertEquals("no slip", create2.getPath(),
            0.036 * (create2.getLeftWheelAngle() + create2.getRightWheelAngle()) / 2, 0.02);
    }

    /**
     * Each motor starts with its last impulse; otherwise wheels solved first drive more, and the car drifts by 58 mm.
     */
    @Test
    public void straightUpASlopeIsStraight() throws Exception {
        new Floor("slope", 50, 50).rotate(-10, 0, 0);
        Robots.car("car").placeAt(-3, 0);
        Robots.fourWheeled("skid").placeAt(0, 0);
        Robots.rover("rover").placeAt(3, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        List<Robot> robots = simulation.getRobots();
        List<Pose> starts = robots.stream().map(Robot::getPose).collect(Collectors.toList());
        robots.forEach(robot -> robot.drive(0.5, Double.POSITIVE_INFINITY));
        Worlds.run(simulation, 10);
        for (int i = 0; i < robots.size(); i++) {
            Pose pose = robots.get(i).getPose();
            assertEquals("robot " + i, 4.9 * Math.cos(Math.toRadians(10)), pose.z - starts.get(i).z, 0.1);
            assertEquals("robot " + i, 0, pose.x - starts.get(i).x, 1e-3);
        }
    }

    private RobotHardware meetsCommands(double speed) throws Exception {
        new Floor("floor", 50, 50);
        Simulation simulation = Worlds.start(project);
        Robot robot = simulation.getRobots().get(0);
        RobotHardware hardware = robot.getHardware();
        Worlds.run(simulation, 3);
        Pose start = robot.getPose();
        double path = hardware.getPath();
        go(simulation, speed, Double.POSITIVE_INFINITY, 1 / speed);
        assertEquals(1, Math.hypot(robot.getPose().x - start.x, robot.getPose().z - start.z), 0.01);
        assertEquals(1, hardware.getPath() - path, 0.01);
        assertEquals(0, robot.getPose().x - start.x, 0.01);

        double half = hardware.getTrack() / 2;
        double turned = hardware.getTurned();
        start = robot.getPose();
        go(simulation, speed / 2, 0, FULL_TURN * half / (speed / 2));
        assertEquals(360, Math.toDegrees(hardware.getTurned() - turned), 2);
        assertEquals(0, Math.hypot(robot.getPose().x - start.x, robot.getPose().z - start.z), 0.02);

        circle(simulation, robot, speed, Math.max(0.5, 4 * half));
        rests(simulation, robot);
        return hardware;
    }

    /** Drives a circle to the left. */
    private static void circle(Simulation simulation, Robot robot, double speed, double radius) {
        robot.drive(speed, radius);
        Worlds.run(simulation, 1);
        double[] centre = robot.getPose().transform(radius, 0, 0);
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (double t = 0; t < FULL_TURN * radius / speed; t += Simulation.STEP) {
            simulation.step();
            double r = Math.hypot(robot.getPose().x - centre[0], robot.getPose().z - centre[2]);
            least = Math.min(least, r);
            most = Math.max(most, r);
        }
        robot.drive(0, 0);
        Worlds.run(simulation, 1);
        assertEquals("diameter", 2 * radius, least + most, 0.02 * radius);
        assertTrue(least + " to " + most, most - least < 0.08 * radius);
    }

    /** Checks that nothing creeps, shakes or counts for a minute. */
    private static void rests(Simulation simulation, Robot robot) {
        Worlds.run(simulation, 2);
        Pose start = robot.getPose();
        double path = robot.getHardware().getPath();
        double left = robot.getHardware().getLeftWheelAngle();
        for (int second = 0; second < 60; second++) {
            Worlds.run(simulation, 1);
            double moved = Math.hypot(robot.getPose().x - start.x, robot.getPose().z - start.z);
            assertTrue("crept " + moved, moved < 0.001);
            assertEquals("height", start.y, robot.getPose().y, 1e-4);
        }
        assertEquals(path, robot.getHardware().getPath(), 0);
        assertEquals(left, robot.getHardware().getLeftWheelAngle(), 1e-6);
    }

    private static void go(Simulation simulation, double speed, double radius, double seconds) {
        Robot robot = simulation.getRobots().get(0);
        robot.drive(speed, radius);
        Worlds.run(simulation, seconds);
        robot.drive(0, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 1);
    }
}
