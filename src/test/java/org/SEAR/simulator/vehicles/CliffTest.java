// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.Slow;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * In safe mode a robot stops at the edge of a table with all wheels on the table, so that it can back off. Several of a
 * kind drive at the same time, each on its own table.
 */
@Category(Slow.class)
public class CliffTest {
    private static final double HEIGHT = 0.7;
    private static final double HALF = 1;
    private static final double APART = 4;
    private static final int[] SPEEDS = {100, 200, 500};
    private static final int[] ANGLES = {0, 0, 0, 0, 20, 45, 70};
    /** Each further robot starts this much nearer to its edge, metres, so that the edge appears in different steps. */
    private static final double PHASE = 0.002;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<SEARrobot> robots = new ArrayList<>();
    private Simulation simulation;

    private interface Kind {
        SEARrobot make(String name, String uart, String user);
    }

    /** Makes a table for each speed and angle, with a robot at its middle. */
    private void build(Kind kind) throws Exception {
        new Floor("floor", 100, 100);
        for (int speed = 0; speed < SPEEDS.length; speed++) {
            for (int angle = 0; angle < ANGLES.length; angle++) {
                String name = SPEEDS[speed] + "mm_s_" + ANGLES[angle] + "deg_" + angle;
                new Box("table " + name, 2 * HALF, 2 * HALF, HEIGHT, 0).move(APART * angle, HEIGHT / 2, APART * speed);
                SEARrobot robot = kind.make(name, name + "uart", name + "user");
                robot.move(APART * angle, HEIGHT, APART * speed + PHASE * angle);
                robot.rotate(0, ANGLES[angle], 0);
                robots.add(robot);
            }
        }
        simulation = Worlds.start(project);
        simulation.getLines().forEach(line -> line.setSink((bytes, starts) -> { }));
        Worlds.run(simulation, 2);
    }

    private void tell(String start, int share) {
        for (int i = 0; i < robots.size(); i++) {
            SerialLine line = simulation.getLines().get(i);
            line.write(Bytes.bytes(start));
            int speed = share * SPEEDS[i / ANGLES.length];
            line.write(ByteBuffer.allocate(5).put((byte) 0x89).putShort((short) speed)
                .putShort((short) 0x8000).array());
        }
    }

    private String mode(int robot) {
        String status = simulation.snapshot().robots.get(robot).devices.get(0).status;
        return status.replaceAll("OI mode: (\\w+).*", "$1");
    }

    private double[] pose(int robot) {
        Pose pose = simulation.snapshot().robots.get(robot).pose;
        return new double[] {pose.x, pose.y, pose.z, pose.rotate(0, 1, 0)[1]};
    }

    private void stopsAtTheEdgeAndBacksOff(Kind kind, String start) throws Exception {
        build(kind);
        List<double[]> before = new ArrayList<>();
        for (int i = 0; i < robots.size(); i++) {
            before.add(pose(i));
        }
        tell(start, 1);
        Worlds.run(simulation, 18);
        List<double[]> stopped = new ArrayList<>();
        for (int i = 0; i < robots.size(); i++) {
            String name = robots.get(i).getName();
            double[] at = pose(i);
            stopped.add(at);
            assertEquals(name + " mode", "passive", mode(i));
            assertEquals(name + " height", before.get(i)[1], at[1], 0.002);
            assertTrue(name + " level " + at[3], at[3] > 0.9995);
            assertEquals(name + " stands", 0, simulation.snapshot().robots.get(i).speed, 0.001);
            assertTrue(name + " drove", Math.hypot(at[0] - before.get(i)[0], at[2] - before.get(i)[2]) > 0.5);
        }
        tell("80 " + (start.contains("82") ? "82" : "83"), -1);
        Worlds.run(simulation, 1);
        for (int i = 0; i < robots.size(); i++) {
            String name = robots.get(i).getName();
            double[] at = pose(i);
            assertEquals(name + " mode while backing off", "safe", mode(i));
            double back = Math.hypot(at[0] - stopped.get(i)[0], at[2] - stopped.get(i)[2]);
            assertEquals(name + " backs off", SPEEDS[i / ANGLES.length] / 1000.0, back,
                0.15 * SPEEDS[i / ANGLES.length] / 1000.0);
            assertEquals(name + " height", before.get(i)[1], at[1], 0.002);
        }
    }

    @Test
    public void aRoomba400() throws Exception {
        stopsAtTheEdgeAndBacksOff(Robots::roomba400, "80 82");
    }

    @Test
    public void aCreate() throws Exception {
        stopsAtTheEdgeAndBacksOff(Robots::create, "80 83");
    }

    @Test
    public void aCreate2() throws Exception {
        stopsAtTheEdgeAndBacksOff(Robots::create2, "80 83");
    }

    /** The dissertation's robot, whose front wheel drops below the rim. */
    @Test
    public void aRobotWithItsFrontWheelBelowTheRim() throws Exception {
        stopsAtTheEdgeAndBacksOff((name, uart, user) -> {
            SEARrobot robot = Worlds.roomba(name, 0, 0, 0);
            for (SearObject part : robot.getComponents()) {
                if (part instanceof Dynamics) {
                    ((Dynamics) part).setPorts(uart, user);
                }
            }
            return robot;
        }, "80 83");
    }
}
