// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** SEAR warns once about commands that a robot can't execute, with its actual motion. */
public class OrdersTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private Simulation simulation;

    private Robot start(SEARrobot object) throws Exception {
        new Floor("floor", 100, 100);
        simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        return simulation.getRobots().get(0);
    }

    private List<String> warnings() {
        Worlds.run(simulation, 0.1);
        return new ArrayList<>(simulation.snapshot().warnings);
    }

    @Test
    public void tooFast() throws Exception {
        Robot rover = start(Robots.rover("rover"));
        rover.drive(0.9, STRAIGHT);
        assertEquals("[]", warnings().toString());
        rover.drive(1.5, STRAIGHT);
        rover.drive(3, STRAIGHT);
        assertEquals("[robot rover can't obey the command to turn its wheels at 1.50 m/s: without load its motors "
            + "reach 1.00 m/s, so it drives"
            + " that fast instead, or slower under load. A motor's noLoadSpeed sets its limit]", warnings().toString());
        Worlds.run(simulation, 2);
        Pose from = simulation.getPose("rover");
        Worlds.run(simulation, 1);
        assertEquals(1, simulation.getPose("rover").z - from.z, 0.05);
    }

    /** Both sides slow down in proportion: the arc keeps its radius. */
    @Test
    public void tooFastOnAnArc() throws Exception {
        Robot rover = start(Robots.rover("rover"));
        rover.drive(1.5, 1);
        Worlds.run(simulation, 3);
        Pose a = simulation.getPose("rover");
        Worlds.run(simulation, 1);
        Pose b = simulation.getPose("rover");
        double turned = 2 * Math.asin(
            Math.min(1, Math.abs(a.rotateBack(b.rotate(0, 0, 1)[0], b.rotate(0, 0, 1)[1], b.rotate(0, 0, 1)[2])[0])
                / 2));
        double chord = Math.hypot(b.x - a.x, b.z - a.z);
        double angle = Math.asin(Math.abs(
            a.rotateBack(b.rotate(0, 0, 1)[0], b.rotate(0, 0, 1)[1], b.rotate(0, 0, 1)[2])[0]));
        assertTrue("turned " + turned, turned > 0.1);
        assertEquals("radius", 1, chord / 2 / Math.sin(angle / 2), 0.06);
    }

    /** Wheels without a Motor have no speed limit; only grip limits them. */
    @Test
    public void tooFastForTheCircle() throws Exception {
        Robot create = start(Robots.create2("create"));
        create.drive(2, 1);
        create.drive(2, STRAIGHT);
        assertEquals("[]", warnings().toString());
        create.drive(20, 1);
        create.drive(-20, -2);
        assertEquals("[robot create can't obey the command to drive at 20.00 m/s on a circle of 1.00 m radius: that "
            + "takes 400.0 m/s\u00b2 of grip,"
            + " and here its wheels have 9.8. It slides outwards instead; drive slower or on a wider circle]",
            warnings().toString());
    }

    /** One warning reports the circle that is too tight, another the excess speed on the tightest circle. */
    @Test
    public void tooFastForTheTightestCircle() throws Exception {
        Robot car = start(Robots.car("car"));
        car.drive(3, 0.1);
        List<String> warnings = warnings();
        assertEquals(warnings.toString(), 1, warnings.stream()
            .filter(text -> text.contains("circle of 0.52 m radius: that takes")).count());
    }

    @Test
    public void tooTight() throws Exception {
        Robot car = start(Robots.car("car"));
        car.drive(0.3, 0.6);
        assertEquals("[]", warnings().toString());
        double spin = Math.toRadians(40) * car.getHardware().getTrack() / 2;
        car.drive(spin, 0);
        car.drive(spin, 0.1);
        assertEquals("[robot car can't obey the command to turn in place: its wheels steer by 30 degrees at most. At "
            + "0.08 m/s it drives on a"
            + " circle of 0.52 m radius instead, and turns at 9.2 degrees per second]", warnings().toString());
        Worlds.run(simulation, 3);
        assertEquals(9.2, Math.toDegrees(simulation.snapshot().robots.get(0).turnRate), 0.3);
        car.drive(0, 0);
        Worlds.run(simulation, 2);
        assertEquals(0, simulation.snapshot().robots.get(0).turnRate, 1e-3);
    }

    /** The mean speed of both rear wheels equals the motor's command, even if the inner wheel is much slower. */
    @Test
    public void aMotorsSpeedIsTheMeanOfItsWheels() throws Exception {
        Robot car = start(Robots.car("car"));
        car.steer(30);
        simulation.getMotor("engine").setSpeed(8);
        Worlds.run(simulation, 3);
        assertEquals(8, simulation.getMotor("engine").getSpeed(), 0.04);
        double speed = 8 * 0.05 / Math.toRadians(1);
        assertEquals("degrees a second", speed * Math.tan(Math.toRadians(30)) / 0.3,
            Math.toDegrees(simulation.snapshot().robots.get(0).turnRate), 2);
    }
}
