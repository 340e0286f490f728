// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.Needs;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.VoltagePoint;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Third-party programs for real Arduinos with StandardFirmata on the exported port of a simulated Uno in real time.
 * They are killed at work and started again {@code sear.driverRestarts} times, then run for {@code sear.driverSeconds}:
 * 20 and 600 in the long run.
 */
@Category(Slow.class)
@Needs({"drivers", "johnnyFive"})
public class ThirdPartyArduinoTest extends WithPrograms {
    private static final String PORT = "/dev/SEAR_UNO_01";
    private static final double STEP = 5.0 / 1024;
    private static final int KILLS = Integer.getInteger("sear.driverRestarts", 1);
    /** Least number of the 52 values per second, for a busy machine. */
    private static final int VALUES_A_SECOND = 10;
    /**
     * Least difference between the middle of a wall and a corner, in steps of the converter; the real one is about 30.
     */
    private static final int SEEN = 12;

    private Distance sharp;

    /** Makes a robot with two motors, a Sharp sensor and a PING))) in the middle of a room of 1.4 m. */
    @Before
    public void start() {
        new Floor("floor", 20, 20);
        for (int way : new int[] {-1, 1}) {
            new Box("wall at z " + way, 2.4, 0.5, 0.5, 0).move(0, 0.25, 0.95 * way);
            new Box("wall at x " + way, 0.5, 1.4, 0.5, 0).move(0.95 * way, 0.25, 0);
        }
        SEARrobot robot = Robots.create2("rover");
        Arduino uno = new Arduino("uno", "uno");
        uno.setFirmware("StandardFirmata");
        uno.setPorts("/dev/my_UNO_01", PORT);
        sharp = new Distance("sharp", "GP2Y0A21");
        sharp.move(0, 0.05, 0.16);
        robot.addComponent(sharp);
        uno.wire("A0", sharp);
        Distance ping = new Distance("ping", "PING)))");
        ping.move(0, 0.3, 0.16);
        robot.addComponent(ping);
        uno.wire(4, ping);
        int pin = 9;
        for (Wheel wheel : robot.getWheels()) {
            if (wheel.isDriven()) {
                Motor motor = new Motor(wheel.getName() + "Motor", wheel, 0.5, 5);
                robot.addComponent(motor);
                uno.wire(pin, motor, "pwm");
                uno.wire(pin++ - 2, motor, "direction");
            }
        }
        robot.addComponent(uno);
        simulate();
    }

    /** Returns the voltage of the data sheet's curve, linear in 1 / distance between its points. */
    private double volts() {
        double distance = sear.getDistanceResult("sharp");
        List<VoltagePoint> curve = sharp.getShape().getVoltages();
        int next = 1;
        while (curve.get(next).getDistance() < distance) {
            next++;
        }
        VoltagePoint near = curve.get(next - 1);
        VoltagePoint far = curve.get(next);
        double share = (1 / near.getDistance() - 1 / distance) / (1 / near.getDistance() - 1 / far.getDistance());
        return near.getVolts() + share * (far.getVolts() - near.getVolts());
    }

    /** Runs twice, so that the program reconnects. */
    @Test
    public void pyfirmata2DrivesAndReads() throws Exception {
        String port = sear.exportPort(PORT);
        for (int i = 0; i < 2; i++) {
            double before = volts();
            double from = sear.getPose("rover")[2];
            List<String> output = programs.run(python("pyfirmata2_drive.py", port, Programs.SECONDS),
                new ArrayList<>());
            assertEquals(output.toString(), 4, output.size());
            assertEquals("StandardFirmata.ino 2.5", output.get(0));
            assertEquals(before, Double.parseDouble(output.get(1)), STEP);
            assertEquals("True", output.get(2));
            double path = sear.getPose("rover")[2] - from;
            assertTrue("drove " + path + " m, with what simulated time a busy machine finds in 1.5 s", path > 0.02);
            assertEquals(volts(), Double.parseDouble(output.get(3)), STEP);
        }
    }

    /** Starts a program, lets it work and kills it, several times. */
    private void kill(ProcessBuilder program) throws Exception {
        for (int i = 0; i < KILLS; i++) {
            Process process = programs.start(program);
            programs.untilItTells(process, "1 s .*");
            process.destroyForcibly().waitFor();
        }
    }

    /**
     * Each line has the number of values per second, their minimum and maximum: the robot turned between walls and
     * corners.
     */
    private static void assertValues(List<String> lines) {
        List<int[]> seconds = lines.stream().filter(line -> line.matches("\\d+ s .*"))
            .map(line -> Arrays.stream(line.replace(" s", "").split(" ")).mapToInt(Integer::parseInt).toArray())
            .collect(Collectors.toList());
        assertEquals(lines.toString(), Programs.SECONDS, seconds.size());
        assertTrue(lines.toString(), seconds.stream().mapToInt(second -> second[1])
            .sum() >= VALUES_A_SECOND * Programs.SECONDS);
        IntSummaryStatistics least = seconds.stream().filter(second -> second[1] > 0).mapToInt(second -> second[2])
            .summaryStatistics();
        IntSummaryStatistics greatest = seconds.stream().mapToInt(second -> second[3]).summaryStatistics();
        assertTrue(lines.toString(), greatest.getMax() - least.getMin() > SEEN);
        assertEquals("done", lines.get(lines.size() - 1));
    }

    @Test
    public void pyfirmata2IsKilledAndReconnects() throws Exception {
        String port = sear.exportPort(PORT);
        kill(python("pyfirmata2_endure.py", port, Programs.PATIENCE));
        assertValues(programs.run(python("pyfirmata2_endure.py", port, Programs.SECONDS), new ArrayList<>()));
    }

    private ProcessBuilder node(int port, int seconds) {
        ProcessBuilder node = new ProcessBuilder("node", SCRIPTS.resolve("johnny_five_drive.js").toString(),
            Integer.toString(port), Integer.toString(seconds));
        node.environment().put("NODE_PATH", System.getProperty("sear.johnnyFive"));
        return node;
    }

    /** Uses TCP, because the program's package for serial ports is machine code from another download. */
    @Test
    public void johnnyFiveDrivesReadsIsKilledAndReconnects() throws Exception {
        int port = sear.exportTcp(PORT, 0);
        kill(node(port, Programs.PATIENCE));
        sear.reset();
        sear.simSleep(1);
        double steps = volts() / STEP;
        double centimetres = 100 * sear.getDistanceResult("ping");
        Process johnny = programs.start(node(port, Programs.SECONDS));
        programs.untilItTells(johnny, "drove");
        double driven = sear.getPose("rover")[2];
        List<String> output = programs.read(johnny, Programs.SECONDS + Programs.PATIENCE);
        assertEquals(output.toString(), 0, johnny.waitFor());
        assertEquals("StandardFirmata.ino, 20 pins", output.get(0));
        assertEquals(steps, Double.parseDouble(output.get(1)), 1.5);
        assertEquals("it takes 29.1 us for a centimetre", centimetres, Double.parseDouble(output.get(2)), 1);
        assertTrue("drove " + driven + " m", driven > 0.02);
        assertValues(output);
    }
}
