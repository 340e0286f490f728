// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.ServiceConfig;
import org.myrobotlab.service.interfaces.SerialDataListener;

/** The Serial service of the embedded MyRobotLab on virtual ports. */
public class SerialTest {
    private Serial user;
    private Serial uart;

    /** Stores bytes until there are enough. */
    public static class Keeper extends Service<ServiceConfig> implements SerialDataListener {
        private static final long serialVersionUID = 1L;

        final transient ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        final transient CountDownLatch enough = new CountDownLatch(1);
        transient int wanted;
        transient Serial line;
        volatile String port;
        volatile Boolean wasConnected;

        public Keeper(String name, String id) {
            super(name, id);
        }

        @Override
        public void onBytes(byte[] data) {
            bytes.write(data, 0, data.length);
            if (bytes.size() >= wanted) {
                enough.countDown();
            }
        }

        @Override
        public void onConnect(String portName) {
            port = portName;
        }

        @Override
        public void onDisconnect(String portName) {
            port = null;
            wasConnected = line == null ? null : line.isConnected();
        }
    }

    @Before
    public void connect() throws IOException {
        user = (Serial) Runtime.start("user", "Serial");
        uart = Serial.connectVirtualUart("/dev/v0");
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    @Test
    public void bytesGoBothWays() throws Exception {
        user.connect("/dev/v0", 9600, 8, 1, 0);
        user.setTimeout(60_000);
        uart.setTimeout(60_000);
        user.write(0x1FF);
        user.write("abc");
        user.write(new byte[] {-1, 0});
        assertArrayEquals(new byte[] {-1, 'a', 'b', 'c', -1, 0}, uart.read(6));
        uart.write("line\nrest");
        assertEquals("line\n", user.readString());
        assertEquals('r', user.read());
        assertEquals("est", user.readString(3));
        assertEquals(9600, user.getRate());
        assertEquals(9, user.getRXCount());
    }

    @Test
    public void aMegabyteInBurstsArrivesWholeAndInOrder() throws Exception {
        Keeper keeper = (Keeper) Runtime.start("keeper", Keeper.class.getName());
        byte[] sent = new byte[1 << 20];
        new Random(7).nextBytes(sent);
        keeper.wanted = sent.length;
        user.addByteListener(keeper);
        user.connect("/dev/v0");
        for (int at = 0, size = 1; at < sent.length; at += size, size = size * 3 % 4999 + 1) {
            size = Math.min(size, sent.length - at);
            uart.write(java.util.Arrays.copyOfRange(sent, at, at + size));
        }
        assertTrue(keeper.enough.await(60, TimeUnit.SECONDS));
        assertArrayEquals(sent, keeper.bytes.toByteArray());
    }

    @Test
    public void anotherPortIsSilentlyIgnoredWhileConnected() throws IOException {
        Serial.connectVirtualUart("/dev/v1");
        user.connect("/dev/v0");
        user.connect("/dev/v1");
        assertEquals("/dev/v0", user.getPortName());
        assertFalse(user.hasError());
        user.disconnect();
        assertFalse(user.isConnected());
        assertNull(user.getPortName());
        user.connect("/dev/v1");
        assertEquals("/dev/v1", user.getPortName());
        assertEquals("/dev/v1", user.getLastPortName());
    }

    @Test
    public void aListenerCountsFromTheNextConnectOn() throws Exception {
        Keeper late = (Keeper) Runtime.start("late", Keeper.class.getName());
        late.wanted = 1;
        user.setTimeout(60_000);
        user.connect("/dev/v0");
        user.addByteListener(late);
        uart.write(1);
        assertEquals(1, user.read());
        assertEquals(0, late.bytes.size());
        user.disconnect();
        user.connect("/dev/v0");
        uart.write(2);
        assertTrue(late.enough.await(60, TimeUnit.SECONDS));
        assertArrayEquals(new byte[] {2}, late.bytes.toByteArray());
    }

    @Test
    public void aPortThatCantBeOpenedThrows() {
        try {
            user.connect("/dev/nix");
            fail("there is no such port");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().startsWith("port /dev/nix can't be opened: "));
        }
        assertFalse(user.isConnected());
    }

    @Test
    public void listenersAreInformedBeforeThePortCloses() throws IOException {
        Keeper keeper = (Keeper) Runtime.start("keeper", Keeper.class.getName());
        keeper.line = user;
        user.addByteListener(keeper);
        user.connect("/dev/v0");
        assertEquals("/dev/v0", keeper.port);
        user.disconnect();
        assertNull(keeper.port);
        assertEquals("connected still", Boolean.TRUE, keeper.wasConnected);
        assertFalse(user.isConnected());
    }

    @Test
    public void writingToAClosedPortIsAnError() throws Exception {
        user.write("a");
        assertEquals("can not write to a closed port: connect first", user.getLastError().key);
    }

    @Test
    public void aReadEndsWithItsTimeout() throws Exception {
        user.connect("/dev/v0");
        user.setTimeout(10);
        try {
            user.read();
            fail("there is nothing to read");
        } catch (IOException e) {
            assertEquals("10 ms timeout was reached - no data", e.getMessage());
        }
        assertEquals(0, user.read(3).length);
    }

    @Test
    public void virtualPortsAreListed() {
        assertTrue(user.getPortNames().contains("/dev/v0"));
        assertTrue(Serial.listPorts().contains("/dev/v0.UART"));
        assertEquals("_dev_v0.UART", uart.getName());
    }
}
