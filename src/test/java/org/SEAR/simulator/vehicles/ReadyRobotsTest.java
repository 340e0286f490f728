// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.edit.ProjectEditor;
import org.SEAR.project.edit.RobotTemplates;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Each robot of the palette drives immediately, except the one without wheels. */
public class ReadyRobotsTest {
    /** Speed of the tab's buttons, m/s. */
    private static final double SPEED = 0.2;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Simulation make(String template) throws Exception {
        ProjectEditor editor = new ProjectEditor(project.folder());
        editor.apply(Map.of("do", "add", "type", "Floor", "name", "floor", "set",
            Map.of("length", "40", "width", "40")));
        editor.apply(Map.of("do", "robot", "template", template, "name", "robot"));
        Simulation simulation = Simulation.of(Project.read(project.folder()), 1);
        assertEquals(template, "[]", simulation.snapshot().warnings.toString());
        assertTrue(simulation.getRobots().get(0).getStability().degrees > 20);
        Worlds.run(simulation, 1);
        return simulation;
    }

    private static double headingOf(Pose pose) {
        double[] ahead = pose.rotate(0, 0, 1);
        return Math.toDegrees(Math.atan2(ahead[0], ahead[2]));
    }

    /** @param rate turn rate in place or on the smallest circle, degrees per second */
    private void drive(String template, double rate) throws Exception {
        Simulation simulation = make(template);
        Robot robot = simulation.getRobots().get(0);
        assertEquals("it stands where it was put", 0, Math.hypot(robot.getPose().x, robot.getPose().z), 0.005);
        robot.drive(SPEED, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 10);
        Pose ahead = robot.getPose();
        assertEquals(2, ahead.z, 0.05);
        assertEquals("straight on", 0, ahead.x, 0.02);
        assertEquals(0, headingOf(ahead), 1);
        assertEquals("level", 1, ahead.rotate(0, 1, 0)[1], 0.001);
        for (int way : new int[] {1, -1}) {
            robot.drive(0, Double.POSITIVE_INFINITY);
            Worlds.run(simulation, 0.5);
            double before = headingOf(robot.getPose());
            robot.drive(way * SPEED, 0);
            Worlds.run(simulation, 1.5);
            double turned = Math.IEEEremainder(headingOf(robot.getPose()) - before, 360) * way;
            assertEquals(template, 1.5 * rate, turned, 0.15 * 1.5 * rate);
        }
        robot.drive(0, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 1);
        Pose halted = robot.getPose();
        robot.drive(-SPEED, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 3);
        double[] way = halted.rotateBack(robot.getPose().x - halted.x, robot.getPose().y - halted.y,
            robot.getPose().z - halted.z);
        assertEquals("backwards, and straight", 0, way[0], 0.03);
        assertEquals(-0.6, way[2], 0.05);
    }

    @Test
    public void theRoversDrive() throws Exception {
        drive("rover", Math.toDegrees(SPEED / 0.1));
    }

    @Test
    public void fourWheelsDrive() throws Exception {
        drive("fourWheeled", Math.toDegrees(SPEED / 0.14));
    }

    @Test
    public void theCarDrives() throws Exception {
        drive("car", Math.toDegrees(SPEED * Math.tan(Math.toRadians(30)) / 0.3));
    }

    @Test
    public void theCleanersDrive() throws Exception {
        drive("create2", Math.toDegrees(SPEED / 0.1175));
    }

    @Test
    public void allStandSafely() throws Exception {
        List<String> withWheels = new ArrayList<>(RobotTemplates.names());
        assertTrue(withWheels.remove("chassis"));
        for (String template : withWheels) {
            make(template);
            new ProjectEditor(project.folder()).apply(Map.of("do", "delete", "object", "robot"));
            new ProjectEditor(project.folder()).apply(Map.of("do", "delete", "object", "floor"));
        }
    }

    @Test
    public void aChassisRestsOnItsBodyAndLacksNothingButWheels() throws Exception {
        ProjectEditor editor = new ProjectEditor(project.folder());
        editor.apply(Map.of("do", "add", "type", "Floor", "name", "floor"));
        editor.apply(Map.of("do", "robot", "template", "chassis", "name", "robot"));
        Simulation simulation = Simulation.of(Project.read(project.folder()), 1);
        assertEquals("[robot robot has no wheels and can't drive: robot.addWheel(Wheel(...)) adds one]",
            simulation.snapshot().warnings.toString());
        Worlds.run(simulation, 2);
        Pose pose = simulation.getRobots().get(0).getPose();
        assertEquals("its underside is on the floor", 0.01, pose.y, 0.002);
        assertEquals("level", 1, pose.rotate(0, 1, 0)[1], 0.001);
    }

    /** A car steers to the commanded circle. A straight drive straightens its wheels, but manual steering stays. */
    @Test
    public void aCarSteersToItsCircle() throws Exception {
        Simulation simulation = make("car");
        Robot car = simulation.getRobots().get(0);
        car.drive(SPEED, 1);
        assertSteering(simulation, Math.toDegrees(Math.atan2(0.3, 1)));
        car.drive(SPEED, -2);
        assertSteering(simulation, -Math.toDegrees(Math.atan2(0.3, 2)));
        car.drive(-SPEED, 0);
        assertSteering(simulation, -30);
        car.drive(SPEED, Double.POSITIVE_INFINITY);
        assertSteering(simulation, 0);
        car.steer(12);
        car.drive(SPEED, Double.POSITIVE_INFINITY);
        assertSteering(simulation, 12);
    }

    /**
     * Different wheel speeds steer a car to their circle; equal ones straighten its wheels, but manual steering stays.
     */
    @Test
    public void aCarSteersByWheelSpeeds() throws Exception {
        Simulation simulation = make("car");
        Robot car = simulation.getRobots().get(0);
        double track = car.getHardware().getTrack();
        double wheelbase = 0.3;
        car.getHardware().setWheelSpeeds(0.2, 0.25);
        assertSteering(simulation, Math.toDegrees(Math.atan(wheelbase * 0.05 / 0.225 / track)));
        car.getHardware().setWheelSpeeds(0.3, 0.3);
        assertSteering(simulation, 0);
        car.getHardware().setWheelSpeeds(0.3, -0.3);
        assertSteering(simulation, -30);
        car.getHardware().setWheelSpeeds(0, 0);
        assertSteering(simulation, -30);
        car.steer(12);
        car.getHardware().setWheelSpeeds(0.3, 0.3);
        assertSteering(simulation, 12);
    }

    private static void assertSteering(Simulation simulation, double degrees) {
        Worlds.run(simulation, 0.5);
        assertEquals(degrees, simulation.getRobots().get(0).getSteering(), 1e-9);
    }
}
