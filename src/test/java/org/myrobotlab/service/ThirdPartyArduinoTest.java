package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.VoltagePoint;
import org.SEAR.POJOs.Wheel;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Programs of others, written for real Arduinos with StandardFirmata, on the exported port of a simulated Uno, in real time. */
public class ThirdPartyArduinoTest {
    private static final Path SCRIPTS = Paths.get(System.getProperty("sear.root", "."), "src/test/drivers").toAbsolutePath();
    private static final String PORT = "/dev/SEAR_UNO_01";
    private static final double STEP = 5.0 / 1024;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private Programs programs;
    private SEAR sear;
    private Distance sharp;

    /** A wall at 0.7 m before a robot with two motors and a Sharp sensor. */
    @Before
    public void start() {
        programs = new Programs(folder);
        System.setProperty("sear.project", folder.getRoot().toPath().resolve("SEARproject").toString());
        System.setProperty("sear.headless", "true");
        new Floor("floor", 20, 20);
        Box wall = new Box("wall", 4, 0.5, 0.5, 0);
        wall.move(0, 0.25, 0.95);
        SEARrobot robot = Robots.create2("rover");
        Arduino uno = new Arduino("uno", "uno");
        uno.setFirmware("StandardFirmata");
        uno.setPorts("/dev/my_UNO_01", PORT);
        sharp = new Distance("sharp", "GP2Y0A21");
        sharp.move(0, 0.05, 0.16);
        robot.addComponent(sharp);
        uno.wire("A0", sharp);
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
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        sear.simSleep(1);
    }

    @After
    public void stop() {
        programs.end();
        sear.stopSimulation();
        Runtime.releaseService("sear");
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
    }

    /** By the data sheet's curve, between whose points the voltage goes linearly with 1 / distance. */
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

    /** Twice, so that a program may come back. */
    @Test
    public void pyfirmata2DrivesAndReads() throws Exception {
        String port = sear.exportPort(PORT);
        for (int i = 0; i < 2; i++) {
            double before = volts();
            double from = sear.getPose("rover")[2];
            ProcessBuilder python = new ProcessBuilder("python3", SCRIPTS.resolve("pyfirmata2_drive.py").toString(), port);
            python.environment().put("PYTHONPATH", System.getProperty("sear.drivers"));
            List<String> output = programs.run(python, new ArrayList<>());
            assertEquals(output.toString(), 4, output.size());
            assertEquals("StandardFirmata.ino 2.5", output.get(0));
            assertEquals(before, Double.parseDouble(output.get(1)), STEP);
            assertEquals("True", output.get(2));
            double path = sear.getPose("rover")[2] - from;
            assertTrue("drove " + path + " m", path > 0.1);
            assertEquals(volts(), Double.parseDouble(output.get(3)), STEP);
        }
    }
}
