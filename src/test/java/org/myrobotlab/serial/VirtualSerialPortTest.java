// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.SEAR.Fuzz;
import org.junit.After;
import org.junit.Test;
import org.myrobotlab.service.interfaces.SerialDataListener;

/** A null-modem cable in memory loses nothing, keeps the order, and takes the time that follows from the baud rate. */
public class VirtualSerialPortTest {
    private static final long PATIENCE = 60_000;

    private final VirtualSerialPort left = new VirtualSerialPort("/dev/left");
    private final VirtualSerialPort right = new VirtualSerialPort("/dev/right");
    private final Collector heard = new Collector("heard");

    private void connect() throws IOException {
        VirtualSerialPort.makeNullModem(left, right);
        left.open();
        right.open();
        right.listen(heard);
    }

    @After
    public void closePorts() {
        left.close();
        right.close();
    }

    @Test
    public void aMegabyteInBurstsArrivesWholeAndInOrder() throws Exception {
        connect();
        left.setPaced(false);
        byte[] sent = new byte[1 << 20];
        Random random = new Random(Fuzz.SEED);
        random.nextBytes(sent);
        for (int at = 0; at < sent.length;) {
            int size = Math.min(sent.length - at, 1 + random.nextInt(20_000));
            left.write(Arrays.copyOfRange(sent, at, at + size));
            at += size;
        }
        assertArrayEquals("seed " + Fuzz.SEED, sent, heard.await(sent.length));
        assertTrue("pieces of " + heard.longest, heard.longest < 1000);
        assertTrue(right.awaitHanded(PATIENCE));
        assertEquals(0, right.getPending());
    }

    @Test
    public void singleBytesAreUnsigned() throws Exception {
        connect();
        left.write(0x8E);
        left.write(-1);
        assertArrayEquals(new byte[] {(byte) 0x8E, (byte) 0xFF}, heard.await(2));
    }

    @Test
    public void bytesForAnUnopenedPortAreLost() throws Exception {
        VirtualSerialPort.makeNullModem(left, right);
        left.open();
        left.write(1);
        right.open();
        right.listen(heard);
        left.write(2);
        assertArrayEquals(new byte[] {2}, heard.await(1));
    }

    @Test
    public void aPortCanBeClosedAndOpenedAgain() throws Exception {
        connect();
        left.write(1);
        heard.await(1);
        right.close();
        Collector second = new Collector("second");
        right.open();
        right.listen(second);
        left.write(2);
        assertArrayEquals(new byte[] {2}, second.await(1));
        assertArrayEquals(new byte[] {1}, heard.await(1));
    }

    @Test
    public void aClosedPortLeavesNoThread() throws Exception {
        connect();
        Thread reader = right.readingThread;
        right.close();
        reader.join(PATIENCE);
        assertFalse(reader.isAlive());
    }

    @Test
    public void queriesDuringCloseReturnListenersOrNone() throws Exception {
        AtomicBoolean done = new AtomicBoolean();
        AtomicReference<Object> wrong = new AtomicReference<>();
        Thread asking = new Thread(() -> {
            while (!done.get() && wrong.get() == null) {
                List<SerialDataListener> listeners = right.getListeners();
                if (listeners.contains(null)) {
                    wrong.set(listeners);
                }
            }
        });
        asking.setUncaughtExceptionHandler((thread, e) -> wrong.set(e));
        asking.start();
        for (int i = 0; i < 3000 && wrong.get() == null; i++) {
            right.open();
            right.listen(heard);
            right.close();
        }
        done.set(true);
        asking.join();
        assertNull(wrong.get());
    }

    @Test
    public void aListenerThatFailsDoesNotEndTheReader() throws Exception {
        connect();
        right.close();
        right.open();
        boolean[] failed = new boolean[1];
        Collector late = new Collector("late") {
            @Override
            public synchronized void onBytes(byte[] chunk) {
                if (!failed[0]) {
                    failed[0] = true;
                    throw new IllegalStateException("on purpose");
                }
                super.onBytes(chunk);
            }
        };
        right.listen(late);
        left.write(1);
        assertTrue(right.awaitHanded(PATIENCE));
        left.write(2);
        assertArrayEquals(new byte[] {2}, late.await(1));
    }

    @Test
    public void aPortInUseNamesItsUser() throws Exception {
        connect();
        try {
            right.listen(new Collector("other"));
            fail("two owners");
        } catch (IllegalStateException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("/dev/right is in use by [heard]"));
        }
    }

    @Test
    public void writingWithoutCableIsReported() throws Exception {
        left.open();
        try {
            left.write(1);
            fail("written nowhere");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("nothing is plugged into port /dev/left"));
        }
    }

    @Test
    public void aNonsenseBaudRateIsRefused() throws Exception {
        try {
            left.setParams(0, 8, 1, 0);
            fail("0 baud");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage()
                .contains("baud rate of port /dev/left is 0, legal: 50 to 4000000"));
        }
    }
}
