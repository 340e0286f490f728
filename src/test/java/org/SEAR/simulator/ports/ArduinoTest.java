// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ports;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.ProjectRule;
import org.SEAR.protocol.firmata.EchoMessage;
import org.SEAR.protocol.firmata.Feature;
import org.SEAR.protocol.firmata.FirmataMessage;
import org.SEAR.protocol.firmata.FirmataReader;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Pin readings of an Arduino on a robot in a world. */
public class ArduinoTest {
    @Rule
    public final ProjectRule project = new ProjectRule();
    private Arduino uno;
    private SEARrobot robot;
    private Simulation simulation;
    private SerialLine line;
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();

    @Before
    public void make() {
        uno = new Arduino("uno");
        robot = Worlds.roomba("rover", 0, 0, 0);
    }

    private void start() throws Exception {
        new Floor("floor", 50, 50);
        uno.setPorts("uart", "user");
        robot.addComponent(uno);
        simulation = Worlds.start(project);
        line = simulation.getLines().get(0);
        line.setSink((bytes, starts) -> heard.write(bytes, 0, bytes.length));
        Worlds.run(simulation, 1);
    }

    private void say(String hex) {
        heard.reset();
        line.write(Bytes.bytes(hex));
    }

    private List<FirmataMessage> messages(int command) {
        List<FirmataMessage> found = new ArrayList<>();
        FirmataReader reader = new FirmataReader(FirmataReader.HOST, message -> {
            if (message.getCommand() == command) {
                found.add(message);
            }
        });
        for (byte each : heard.toByteArray()) {
            reader.accept(each & 0xFF);
        }
        return found;
    }

    /** Makes a wall at z = 1.5 m. */
    private void wall() {
        Box wall = new Box("wall", 4, 0.2, 1, 0);
        wall.move(0, 0.5, 1.6);
    }

    private Distance ahead(String name, String beam, double z) {
        Distance sensor = new Distance(name, beam, 0, 0.2, z, 0, 0, 0);
        robot.addComponent(sensor);
        return sensor;
    }

    private double distance(String name) {
        return ((DistanceReading) simulation.read(name)).getDistance();
    }

    /** The data sheet's curve of the GP2Y0A21 at 30 cm, as 10 bits of 5 V. */
    @Test
    public void aSharpAtAnAnalogPin() throws Exception {
        wall();
        uno.setFirmware("StandardFirmata");
        uno.wire("A0", ahead("sharp", "GP2Y0A21", 1.2));
        start();
        say("C0 01");
        Worlds.run(simulation, 1);
        List<FirmataMessage> samples = messages(FirmataMessage.ANALOG);
        assertEquals(53, samples.size(), 3);
        double volts = simulation.read("sharp").volts();
        assertEquals(0.3, distance("sharp"), 0.01);
        assertTrue(volts > 0.8 && volts < 1.2);
        assertEquals(volts / 5 * 1024, samples.get(samples.size() - 1).getNumber(0), 1);
    }

    @Test
    public void theEchoOfAPingLastsAsLongAsTheSoundTravels() throws Exception {
        wall();
        uno.setFirmware("StandardFirmata");
        uno.wire(7, ahead("ping", "PING)))", 0.2));
        uno.wire(8, ahead("open", "PING)))", -3));
        start();
        line.write(EchoMessage.request(7, true, 5, 1000000).toBytes());
        Worlds.run(simulation, 0.2);
        FirmataMessage answer = messages(FirmataMessage.START_SYSEX).get(0);
        assertEquals(Feature.ECHO, answer.getId());
        assertEquals(2 * distance("ping") / 343.2 * 1e6, EchoMessage.duration(answer), 1);
    }

    /** MyRobotLab's UltrasonicSensor service with an HC-SR04 at two pins. */
    @Test
    public void centimetresOfAnHcSr04() throws Exception {
        wall();
        Distance sonar = ahead("sonar", "ultrasonic", 0.2);
        uno.wire(12, sonar, "trigger");
        uno.wire(11, sonar, "echo");
        start();
        say("AA 04 2F 01 0C 0B AA 02 30 01");
        Worlds.run(simulation, 0.5);
        String told = Bytes.hex(heard.toByteArray());
        int centimetres = (int) Math.round(distance("sonar") * 2 / 343.2 / 57e-6);
        assertTrue(told, told.contains("AA 04 32 01 00 " + Bytes.hex(new byte[] {(byte) centimetres})));
    }

    /** Adds motors to the wheels, driven as by MyRobotLab's Motor service: direction and pulses. */
    private void motors() {
        robot.getWheels().stream().filter(Wheel::isDriven).forEach(wheel -> {
            Motor motor = new Motor(wheel.getName() + "Motor", wheel, 50, 20);
            robot.addComponent(motor);
            uno.wire(wheel.getName().endsWith("Left") ? 9 : 10, motor);
            uno.wire(wheel.getName().endsWith("Left") ? 7 : 8, motor, "direction");
            if (wheel.getName().endsWith("Left")) {
                uno.wire(2, motor, "encoderA");
                uno.wire(4, motor, "encoderB");
            }
        });
    }

    @Test
    public void motorsDriveForwardAndBackByPwmAndDirection() throws Exception {
        motors();
        start();
        say("AA 03 1E 07 01 AA 03 1E 08 01 AA 03 1B 07 01 AA 03 1B 08 01 AA 03 1A 09 80 AA 03 1A 0A 80");
        Worlds.run(simulation, 2);
        double forward = simulation.getPose("rover").z;
        assertTrue("drove to " + forward, forward > 0.2);
        say("AA 03 1B 07 00 AA 03 1B 08 00");
        Worlds.run(simulation, 4);
        assertTrue("and back", simulation.getPose("rover").z < forward - 0.1);
        line.open();
        Worlds.run(simulation, 1.5);
        double stopped = simulation.getPose("rover").z;
        Worlds.run(simulation, 1);
        assertEquals("a board that resets lets go of its motors", stopped, simulation.getPose("rover").z, 0.01);
    }

    @Test
    public void anEncoderCountsWithTheMotor() throws Exception {
        uno.setFirmware("StandardFirmata");
        motors();
        start();
        say("F0 61 00 00 02 04 F7 F4 07 01 F4 08 01 F4 09 03 F4 0A 03 90 00 01 91 01 00 E9 7F 00 EA 7F 00");
        Worlds.run(simulation, 2);
        say("F0 61 01 00 F7");
        Worlds.run(simulation, 0.2);
        FirmataMessage told = messages(FirmataMessage.START_SYSEX).get(0);
        long counts = told.getNumber(1) | (long) told.getNumber(3) << 14;
        double turns = simulation.getPose("rover").z / (2 * Math.PI * 0.0381);
        assertEquals(0, told.get(0));
        assertEquals("counts of a wheel of 360 lines", turns * 360, counts, turns * 36 + 20);
    }

    /** The snapshot has the pins that the tab shows. */
    @Test
    public void snapshotsHaveThePinsThatSomethingIsWiredTo() throws Exception {
        wall();
        uno.setFirmware("StandardFirmata");
        uno.wire("A0", ahead("sharp", "GP2Y0A21", 1.2));
        motors();
        start();
        say("F4 07 01 F5 07 01 F4 09 03 E9 00 01");
        Worlds.run(simulation, 0.2);
        List<String> pins = new ArrayList<>();
        simulation.snapshot().robots.get(0).devices.get(0).pins.forEach(pin -> pins.add(pin.toString()));
        double volts = simulation.read("sharp").volts();
        assertEquals(7, pins.size());
        assertTrue(pins.toString(), pins.contains("7 roverLeftMotor (direction): output, high"));
        assertTrue(pins.toString(), pins.contains("9 roverLeftMotor (pwm): pwm, 50 %"));
        assertTrue(pins.toString(), pins.contains(
            String.format(Locale.ROOT, "A0 sharp (volts): input, %.2f V", volts)));
        simulation.power("uno", false);
        assertEquals(List.of(), simulation.snapshot().robots.get(0).devices.get(0).pins);
    }

    /** johnny-five turns a servo to 45 degrees: 45 degrees clockwise from the middle. */
    @Test
    public void aServoTurnsByItsPulses() throws Exception {
        uno.setFirmware("StandardFirmata");
        Servo neck = new Servo("neck", 0, 0.2, 0);
        robot.addComponent(neck);
        Distance eye = new Distance("eye", "laser", 0, 0.2, 0.05, 0, 0, 0);
        robot.addComponent(eye);
        neck.mount(eye);
        uno.wire(10, neck);
        start();
        double before = simulation.getPose("eye").x;
        say("F0 70 0A 20 04 60 12 F7 EA 2D 00");
        Worlds.run(simulation, 1);
        assertEquals(before - 0.05 * Math.sin(Math.toRadians(45)), simulation.getPose("eye").x, 0.002);
        say("EA 7F 12");
        Worlds.run(simulation, 1);
        assertEquals("beyond its range it stays at its end", before + 0.05, simulation.getPose("eye").x, 0.002);
    }

    /** Adds a switch between pin 2 and ground at the robot's front. */
    private void bumper() throws Exception {
        wall();
        Box plate = new Box("plate", 0.2, 0.02, 0.05, 0);
        plate.move(0, 0.03, 0.25);
        robot.addComponent(plate);
        Bumper bumper = new Bumper("front", plate);
        robot.addComponent(bumper);
        uno.wire(2, bumper);
        start();
    }

    private void drive(double speed, double seconds) {
        simulation.getRobots().get(0).drive(speed, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, seconds);
    }

    /**
     * Requests of johnny-five's Switch and pyFirmata2: pull-up, reports of port 0. Bit 2 is high while the bumper is
     * free.
     */
    @Test
    public void aBumperPullsItsPinLow() throws Exception {
        uno.setFirmware("StandardFirmata");
        bumper();
        say("F4 02 0B D0 01");
        Worlds.run(simulation, 0.5);
        assertEquals("90 04 00", Bytes.hex(heard.toByteArray()));
        assertEquals("2 front (switch): pullup, 5.00 V", simulation.snapshot().robots.get(0).devices.get(0).pins.get(0)
            .toString());
        heard.reset();
        drive(0.4, 6);
        String told = Bytes.hex(heard.toByteArray());
        assertTrue("it may bounce: " + told, told.startsWith("90 00 00") && told.endsWith("90 00 00"));
        assertEquals("2 front (switch): pullup, 0.00 V", simulation.snapshot().robots.get(0).devices.get(0).pins.get(0)
            .toString());
        heard.reset();
        drive(-0.4, 1);
        assertEquals("90 04 00", Bytes.hex(heard.toByteArray()));
    }

    /** MyRobotLab's Arduino service: pinMode(2, "INPUT_PULLUP"), enablePin(2, 10). */
    @Test
    public void aBumperAsMrlCommReadsIt() throws Exception {
        bumper();
        say("AA 03 1E 02 02 AA 05 04 02 00 00 0A");
        Worlds.run(simulation, 0.5);
        String told = Bytes.hex(heard.toByteArray());
        assertTrue(told, told.contains("AA 05 20 03 02 00 01") && !told.contains("AA 05 20 03 02 00 00"));
        drive(0.4, 6);
        heard.reset();
        Worlds.run(simulation, 0.5);
        told = Bytes.hex(heard.toByteArray());
        assertTrue(told, told.contains("AA 05 20 03 02 00 00") && !told.contains("AA 05 20 03 02 00 01"));
    }

    /** Firmata's digital and PWM messages: on at pin 13, half at pin 9; a reset switches both off. */
    @Test
    public void lightsAtADigitalAndAPwmPin() throws Exception {
        uno.setFirmware("StandardFirmata");
        leds();
        say("F4 0D 01 F5 0D 01 F4 09 03 E9 00 01");
        Worlds.run(simulation, 0.2);
        assertEquals(List.of(1.0, 128 / 255.0), simulation.snapshot().robots.get(0).lights);
        assertEquals("[9 dim (light): pwm, 50 %, 13 lamp (light): output, high]",
            simulation.snapshot().robots.get(0).devices.get(0).pins.toString());
        say("FF");
        Worlds.run(simulation, 0.2);
        assertEquals(List.of(0.0, 0.0), simulation.snapshot().robots.get(0).lights);
    }

    private void leds() throws Exception {
        Led lamp = new Led("lamp", 0, 0.1, 0.1);
        Led dim = new Led("dim", "yellow", 0, 0.1, 0);
        robot.addComponent(lamp);
        robot.addComponent(dim);
        uno.wire(13, lamp);
        uno.wire(9, dim);
        start();
    }

    /** MyRobotLab's Arduino service: pinMode, digitalWrite, analogWrite. */
    @Test
    public void lightsAsMrlCommSwitchesThem() throws Exception {
        leds();
        say("AA 03 1E 0D 01 AA 03 1B 0D 01 AA 03 1E 09 01 AA 03 1A 09 33");
        Worlds.run(simulation, 0.2);
        assertEquals(List.of(1.0, 0.2), simulation.snapshot().robots.get(0).lights);
        say("AA 03 1B 0D 00");
        Worlds.run(simulation, 0.2);
        assertEquals(List.of(0.0, 0.2), simulation.snapshot().robots.get(0).lights);
    }

    @Test
    public void openingThePortResetsTheBoard() throws Exception {
        start();
        line.open();
        Worlds.run(simulation, 1.1);
        assertTrue(Bytes.hex(heard.toByteArray()).endsWith("AA 02 3A 44"));
        heard.reset();
        simulation.reset();
        Worlds.run(simulation, 0.9);
        assertEquals("on since long", 0, heard.size());
    }

    @Test
    public void aFloatingPinIsTheSameInEachRun() throws Exception {
        uno.setFirmware("StandardFirmata");
        start();
        say("C3 01");
        Worlds.run(simulation, 2);
        String first = Bytes.hex(heard.toByteArray());
        assertTrue(first.length() > 800);
        simulation.reset();
        Worlds.run(simulation, 1);
        say("C3 01");
        Worlds.run(simulation, 2);
        assertEquals(first, Bytes.hex(heard.toByteArray()));
    }

    private static void refused(String message, Runnable wiring) {
        try {
            wiring.run();
            fail(message);
        } catch (IllegalArgumentException e) {
            assertEquals(message, e.getMessage());
        }
    }

    @Test
    public void wrongWiringIsRefusedWithThePinsThatCan() {
        Distance sharp = new Distance("sharp", "GP2Y0A21");
        Distance ping = new Distance("ping", "PING)))");
        refused("Arduino \"uno\": pin A9 is no pin of an Uno, legal: A0 to A5 for volts", () -> uno.wire("A9", sharp));
        refused("Arduino \"uno\": pin 7 is not an analog input of an Uno, legal: A0 to A5 for volts",
            () -> uno.wire(7, sharp));
        uno.wire(7, ping);
        refused("Arduino \"uno\": Distance \"ping\" has its ping at pin 7 already, legal: one pin for it; "
            + "unwire(\"7\") removes that wire", () -> uno.wire(8, ping));
        refused("Arduino \"uno\": pin D7 is wired to ping (ping) already, legal: 2 to 6, 8 to 13, A0 to A5 for ping",
            () -> uno.wire("D7", new Distance("other")));
        refused("Arduino \"uno\": role is \"volts\", legal for Distance \"ping\": ping, trigger, echo",
            () -> uno.wire("A0", ping, "volts"));
        refused("Arduino \"uno\": role is \"power\", legal for Distance \"ping\": ping, trigger, echo",
            () -> uno.wire("A0", ping, "power"));
        Motor motor = new Motor("left", new Wheel("wheel", 0.1, 0.05));
        refused("Arduino \"uno\": pin A0 is not a PWM pin of an Uno, legal: 3, 5, 6, 9 to 11 for pwm",
            () -> uno.wire("A0", motor));
        refused("Arduino \"uno\": pin 4 is not a pin with an interrupt of an Uno, legal: 2, 3 for encoderA",
            () -> uno.wire(4, motor, "encoderA"));
        refused("Arduino \"uno\": role is \"volts\", legal for Bumper \"front\": switch",
            () -> uno.wire("A0", new Bumper("front"), "volts"));
        refused("Arduino \"uno\": nothing is wired to pin 9, legal: 7", () -> uno.unwire(9));
        GPS gps = new GPS("gps");
        try {
            uno.wire(9, gps);
            fail("a GPS has no wires");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage()
                .startsWith("Arduino \"uno\": GPS \"gps\" has no wires for the pins of an Arduino, legal: "));
        }
    }
}
