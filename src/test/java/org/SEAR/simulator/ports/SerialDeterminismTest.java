// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ports;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** The same bytes written at the same steps give the same bytes on every port. */
@Category(Slow.class)
public class SerialDeterminismTest {
    private static final int STEPS = 1800;
    /** LMS200: type; status; one scan; send all scans. */
    private static final String[] LMS = {"02 00 01 00 3A 1E 12", "02 00 01 00 31 15 12", "02 00 02 00 30 01 31 18",
        "02 00 02 00 20 24 34 08"};
    /** LMS111, in CoLa: log in; fine fan; state; one scan; send all scans. */
    private static final String[] COLA =
        {hexOf("sMN SetAccessMode 03 F4724744"), hexOf("sMN mLMPsetscancfg +2500 +1 +2500 -450000 +2250000"),
        hexOf("sRN STlms"), hexOf("sRN LMDscandata"), hexOf("sEN LMDscandata 1")};
    /**
     * Roomba: start and full mode; drive at 200 mm/s straight; sensor groups; stream of bumps, distance and angle;
     * stop.
     */
    private static final String[] ROOMBA = {"80 84", "89 00 C8 80 00", "8E 00", "94 03 07 13 14",
        "89 01 2C 01 F4", "8E 06"};
    /** URG-04LX, in SCIP 2.0: parameters; laser on; one scan; a stream; state. */
    private static final String[] SCIP = {textOf("PP"), textOf("BM"), textOf("GD0044072501"), textOf("MS0044072502000"),
        textOf("II")};
    /** RPLIDAR A1: type; health; standard scans; express scans. */
    private static final String[] RPLIDAR = {"A5 50", "A5 52", "A5 20", "A5 82 05 00 00 00 00 00 22"};
    private static final Map<String, String[]> SCRIPTS = Map.of("lidar", LMS, "network", COLA, "hokuyo", SCIP,
        "rplidar", RPLIDAR);

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static String textOf(String line) {
        return Bytes.hex((line + "\n").getBytes(StandardCharsets.US_ASCII));
    }

    private static String hexOf(String telegram) {
        return "02 " + Bytes.hex(telegram.getBytes(StandardCharsets.US_ASCII)) + " 03";
    }

    private static byte[] hex(String text) {
        String[] parts = text.split(" ");
        byte[] bytes = new byte[parts.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) Integer.parseInt(parts[i], 16);
        }
        return bytes;
    }

    private static void world() {
        new Floor("floor", 50, 50);
        for (int i = 0; i < 12; i++) {
            Box box = new Box("box" + i, 0.3, 0.3, 0.3, i % 2 == 0 ? 0 : 1);
            box.move(2.5 * Math.sin(i), 0.15, 2.5 * Math.cos(i));
        }
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 20);
        robot.getComponents().stream().filter(part -> part instanceof Dynamics)
            .forEach(part -> ((Dynamics) part).setPorts("oiUart", "oiUser"));
        LIDAR lidar = new LIDAR("lidar", 8, 180, 1, 0, 0.1, 0.1);
        lidar.setNoise(new Noise().setWhite(0.01));
        lidar.setPorts("lidarUart", "lidarUser");
        robot.addComponent(lidar);
        addScanner(robot, "hokuyo", "URG-04LX");
        addScanner(robot, "rplidar", "RPLIDAR-A1");
        LIDAR network = new LIDAR("network");
        network.setModel("LMS111");
        network.move(0, 0.2, 0.1);
        network.setNoise(new Noise().setWhite(0.01));
        network.setPorts("networkUart", "networkUser");
        robot.addComponent(network);
    }

    private static void addScanner(SEARrobot robot, String name, String model) {
        LIDAR scanner = new LIDAR(name);
        scanner.setModel(model);
        scanner.move(0, 0.25, 0.1);
        scanner.setNoise(new Noise().setWhite(0.01));
        scanner.setPorts(name + "Uart", name + "User");
        robot.addComponent(scanner);
    }

    private static List<ByteArrayOutputStream> listen(Simulation simulation) {
        List<ByteArrayOutputStream> heard = new ArrayList<>();
        for (SerialLine line : simulation.getLines()) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            heard.add(bytes);
            line.setSink((each, starts) -> bytes.write(each, 0, each.length));
        }
        return heard;
    }

    /**
     * Runs the scripted bytes.
     * @return hash of each port's output
     */
    private static int[] run(Simulation simulation) {
        List<ByteArrayOutputStream> heard = listen(simulation);
        for (int step = 0; step < STEPS; step++) {
            for (SerialLine line : simulation.getLines()) {
                String[] script = SCRIPTS.getOrDefault(line.getObjectName(), ROOMBA);
                int next = (step - 600) / 120;
                if (step >= 600 && step % 120 == 0 && next < script.length) {
                    line.write(hex(script[next]));
                }
            }
            simulation.step();
        }
        int[] hashes = new int[heard.size()];
        for (int i = 0; i < hashes.length; i++) {
            assertTrue(simulation.getLines().get(i).getObjectName() + " said " + heard.get(i).size() + " bytes",
                heard.get(i).size() > 500);
            hashes[i] = Arrays.hashCode(heard.get(i).toByteArray());
        }
        return hashes;
    }

    @Test
    public void aFreshStartAndAResetGiveTheSameBytes() throws Exception {
        world();
        Simulation simulation = Worlds.start(project);
        int[] first = run(simulation);
        assertEquals(5, first.length);
        simulation.reset();
        assertEquals("after reset", Arrays.toString(first), Arrays.toString(run(simulation)));
        assertEquals("fresh start", Arrays.toString(first), Arrays.toString(run(Worlds.start(project))));
        int[] otherSeed = run(Simulation.of(Project.read(project.folder()), 2));
        assertNotEquals("the seed is in the LIDAR's noise", Arrays.toString(first), Arrays.toString(otherSeed));
    }
}
