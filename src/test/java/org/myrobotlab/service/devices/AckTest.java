// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.PortListener;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;

/**
 * In lock-step MrlComm acknowledges while the script's thread, which alone advances time, waits for the
 * acknowledgement, as MyRobotLab's Arduino service does.
 */
public class AckTest {
    private static final String PORT = "/dev/SEAR_UNO_01";
    private static final String INFO = "AA 09 03 44 02 03 E8 04 00 00 00";
    private static final int COMMANDS = 60;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();
    private SEAR sear;
    private Serial serial;
    private Listener listener;

    /** Stores received bytes with their times. */
    public static class Listener extends PortListener {
        private static final long serialVersionUID = 1L;
        private final transient BlockingQueue<Byte> bytes = new LinkedBlockingQueue<>();
        private final transient Map<Double, String> log = new TreeMap<>();
        private transient SEAR clock;

        public Listener(String name, String id) {
            super(name, id);
        }

        @Override
        public void onBytes(byte[] values) {
            log.merge(clock.getTime(), Bytes.hex(values), (before, more) -> before + " " + more);
            for (byte each : values) {
                bytes.add(each);
            }
        }
    }

    @Before
    public void start() {
        new Floor("floor", 20, 20);
        SEARrobot robot = Robots.create2("rover");
        Arduino uno = new Arduino("uno");
        uno.setPorts("/dev/my_UNO_01", PORT);
        robot.addComponent(uno);
        sear = (SEAR) Runtime.start("ackSear", "SEAR");
    }

    private void begin() {
        sear.startSimulation();
        serial = (Serial) Runtime.start("ackSerial", "Serial");
        listener = (Listener) Runtime.start("ackListener", Listener.class.getName());
        listener.clock = sear;
        serial.addByteListener(listener);
    }

    /** Returns received bytes by simulated time. */
    private Map<Double, String> end() {
        sear.stopSimulation();
        Map<Double, String> log = listener.log;
        Runtime.releaseService("ackSerial");
        Runtime.releaseService("ackListener");
        return log;
    }

    /** Reads an open analog pin in each loop, writes a digital one and usually waits for the acknowledgement. */
    private Map<Double, String> run() throws Exception {
        begin();
        serial.connect(PORT, 115200, 8, 1, 0);
        sear.simSleep(1.5);
        listener.bytes.clear();
        command("AA 05 04 0E 01 00 00");
        for (int i = 0; i < COMMANDS; i++) {
            double time = sear.getTime();
            command(i % 2 == 0 ? "AA 03 1B 0D 01" : "AA 03 1A 09 80");
            assertEquals("no time has passed", time, sear.getTime(), 0);
            if (i % 5 == 0) {
                serial.write(Bytes.bytes("AA 03 1B 0D 00"));
                sear.simSleep(0.05);
                assertTrue(listener.log.get(time), listener.log.get(time).endsWith("AA 02 09 1B"));
                listener.bytes.clear();
            }
        }
        return end();
    }

    private void command(String hex) throws Exception {
        byte[] bytes = Bytes.bytes(hex);
        serial.write(bytes);
        await("AA 02 09 " + Bytes.hex(new byte[] {bytes[2]}));
    }

    /**
     * Opens the port, does other work and waits for the board's first message, as MyRobotLab's Arduino service does.
     */
    private Map<Double, String> connect() throws Exception {
        begin();
        sear.simSleep(2.5);
        serial.connect(PORT, 115200, 8, 1, 0);
        Thread other = new Thread(() -> {
            for (int i = 0; i < COMMANDS; i++) {
                sear.getGroundHeight(0, 0);
            }
        });
        other.start();
        while (other.isAlive()) {
            Thread.onSpinWait();
        }
        assertTrue("nothing comes before it is waited for", listener.bytes.isEmpty());
        double time = sear.getTime();
        await(INFO);
        assertEquals("no time has passed", time, sear.getTime(), 0);
        command("AA 03 1B 0D 01");
        sear.simSleep(1.5);
        return end();
    }

    private void await(String hex) throws Exception {
        byte[] wanted = Bytes.bytes(hex);
        for (int found = 0; found < wanted.length;) {
            Byte value = listener.bytes.poll(1, TimeUnit.DAYS);
            found = value == wanted[found] ? found + 1 : value == wanted[0] ? 1 : 0;
        }
    }

    @Test(timeout = 120_000)
    public void openingThePortReturnsTheBoardInfoWithTheSameBytesEachTime() throws Exception {
        Map<Double, String> first = connect();
        assertEquals(first, connect());
        assertTrue("and a second later again", first.get(first.keySet().stream().reduce(0.0, Math::max))
            .contains(INFO));
    }

    @Test(timeout = 120_000)
    public void aCommandTakesNoSimulatedTimeAndGivesTheSameBytesEachTime() throws Exception {
        Map<Double, String> first = run();
        assertEquals(first, run());
        assertTrue(first.toString(), first.toString().contains("AA 05 20 03 0E"));
    }
}
