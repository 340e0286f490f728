package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.ProjectRule;
import org.SEAR.protocol.firmata.EchoMessage;
import org.SEAR.protocol.firmata.Feature;
import org.SEAR.protocol.firmata.FirmataMessage;
import org.SEAR.protocol.firmata.FirmataReader;
import org.SEAR.sensors.DistanceReading;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** An Arduino on a robot in a world: what its pins read there. */
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
        line.setSink(bytes -> heard.write(bytes, 0, bytes.length));
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

    /** A wall at z = 1.5 m. */
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
        double volts = ((DistanceReading) simulation.read("sharp")).getVolts();
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

    /** MyRobotLab's UltrasonicSensor service on an HC-SR04 at two pins. */
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

    @Test
    public void openingThePortResetsTheBoard() throws Exception {
        start();
        line.pickUp();
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
        refused("Arduino \"uno\": pin 7 is not an analog input of an Uno, legal: A0 to A5 for volts", () -> uno.wire(7, sharp));
        uno.wire(7, ping);
        refused("Arduino \"uno\": Distance \"ping\" has its ping at pin 7 already, legal: one pin for it; unwire(\"7\") pulls the wire out",
            () -> uno.wire(8, ping));
        refused("Arduino \"uno\": pin D7 is wired to ping (ping) already, legal: 2 to 6, 8 to 13, A0 to A5 for ping",
            () -> uno.wire("D7", new Distance("other")));
        refused("Arduino \"uno\": role is \"volts\", legal for Distance \"ping\": ping, trigger, echo", () -> uno.wire("A0", ping, "volts"));
        refused("Arduino \"uno\": role is \"power\", legal for Distance \"ping\": ping, trigger, echo", () -> uno.wire("A0", ping, "power"));
        refused("Arduino \"uno\": nothing is wired to pin 9, legal: 7", () -> uno.unwire(9));
        GPS gps = new GPS("gps");
        try {
            uno.wire(9, gps);
            fail("a GPS has no wires");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().startsWith("Arduino \"uno\": GPS \"gps\" has no wires for the pins of an Arduino, legal: "));
        }
    }
}
