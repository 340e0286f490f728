// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertTrue;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.SEAR.devices.SerialLine;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.Timeout;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.run.ExternalLine;

/** A program that pauses loses whole messages of its device, and never a part of one. */
public class WholeMessagesTest {
    private static final int SIZE = 1001;
    /** Bytes that leave the line in one step. */
    private static final int PIECE = 300;
    private static final int TELNET_COMMAND = 0xFF;

    /** A program that waits for the rest of a cut message would wait forever. */
    @Rule
    public final Timeout timeout = Timeout.seconds(240);

    private final RecordingHost host = new RecordingHost();
    private final VirtualSerialPort user = new VirtualSerialPort("/dev/test_user");
    private final PortBridge bridge = new PortBridge("/dev/test_user", host);
    private SerialLine.Sink device;
    private final CountDownLatch heard = new CountDownLatch(1);
    private int begun;

    @Before
    public void plugIn() throws IOException {
        bridge.attach(user, new ExternalLine() {
            @Override
            public void write(byte[] bytes) {
                heard.countDown();
            }

            @Override
            public void setReader(SerialLine.Sink reader) {
                device = reader;
            }

            @Override
            public void pickUp() {
                // The device has a cable.
            }

            @Override
            public void hangUp() {
                // The device has a cable.
            }

            @Override
            public int getDeviceBaud() {
                return 9600;
            }
        });
    }

    @After
    public void unplug() {
        bridge.close();
    }

    /** A message that begins with its number. */
    private static byte[] message(int number) {
        byte[] bytes = new byte[SIZE];
        Arrays.fill(bytes, (byte) number);
        ByteBuffer.wrap(bytes).putInt(number);
        return bytes;
    }

    /** Sends the next message in pieces, as a line does. */
    private void send() {
        byte[] bytes = message(begun++);
        for (int at = 0; at < SIZE; at += PIECE) {
            device.receive(Arrays.copyOfRange(bytes, at, Math.min(SIZE, at + PIECE)), at == 0 ? new int[] {0}
                : new int[] {});
        }
    }

    private void check(InputStream stream) throws IOException {
        DataInputStream program = new DataInputStream(stream);
        int read = 0;
        int last = -1;
        for (int dropped : new int[] {1, 10, 100}) {
            host.warnings.clear();
            while (host.warnings.isEmpty()) {
                send();
            }
            for (; read < begun - dropped; read++) {
                byte[] bytes = new byte[SIZE];
                program.readFully(bytes);
                int number = ByteBuffer.wrap(bytes).getInt();
                assertTrue(number + " after " + last, number > last && number < begun);
                assertArrayEquals("message " + number, message(number), bytes);
                last = number;
            }
            String warning = host.warnings.get(0);
            assertTrue(warning, warning.contains("reads too slowly")
                && (dropped == 1 || warning.endsWith("(" + dropped + " times so far)")));
        }
        send();
        assertArrayEquals("the next message", message(begun - 1), program.readNBytes(SIZE));
    }

    @Test
    public void aPausedProgramAtAPseudoTerminal() throws IOException {
        PseudoTerminal terminal = PseudoTerminal.open("/dev/test_user", null);
        bridge.add(terminal);
        try (RandomAccessFile program = new RandomAccessFile(terminal.getPath(), "rw")) {
            check(Channels.newInputStream(program.getChannel()));
        }
    }

    @Test
    public void aPausedProgramAtATcpPort() throws Exception {
        TcpEndpoint server = TcpEndpoint.open("/dev/test_user", TcpSession.RAW, 0);
        bridge.add(server);
        try (Socket program = connected(server)) {
            check(program.getInputStream());
        }
    }

    @Test
    public void aPausedProgramAtAnRfc2217Port() throws Exception {
        TcpEndpoint server = TcpEndpoint.open("/dev/test_user", Rfc2217.KIND, 0);
        bridge.add(server);
        try (Socket program = connected(server)) {
            check(new FilterInputStream(new BufferedInputStream(program.getInputStream())) {
                @Override
                public int read() throws IOException {
                    int value = super.read();
                    return value == TELNET_COMMAND ? super.read() : value;
                }

                @Override
                public int read(byte[] bytes, int from, int count) throws IOException {
                    for (int i = 0; i < count; i++) {
                        bytes[from + i] = (byte) read();
                    }
                    return count;
                }
            });
        }
    }

    /** Connects a program, and waits until the server reads its bytes. */
    private Socket connected(TcpEndpoint server) throws Exception {
        Socket program = new Socket(InetAddress.getLoopbackAddress(), server.getNumber());
        program.getOutputStream().write(1);
        assertTrue("the server has accepted", heard.await(60, TimeUnit.SECONDS));
        return program;
    }
}
