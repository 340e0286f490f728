// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.SEAR.Bytes;
import org.SEAR.Slow;
import org.SEAR.devices.SerialLine;
import org.junit.After;
import org.junit.Assume;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.BytesListener;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.run.ExternalLine;
import org.myrobotlab.service.sear.run.SimulationControl;

/** Any program of the computer can open a virtual port and come and go. */
@Category(Slow.class)
public class ExportsTest {
    private static final int FLOOD = 1 << 20;
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private final RecordingHost host = new RecordingHost();
    private final Exports exports = new Exports(host, new SimulationControl(host, () -> null));
    private final VirtualSerialPort device = new VirtualSerialPort("/dev/test_uart");
    private final VirtualSerialPort user = new VirtualSerialPort("/dev/test_user");
    private final ByteArrayOutputStream received = new ByteArrayOutputStream();

    @Before
    public void plugIn() throws IOException {
        VirtualSerialPort.makeNullModem(device, user);
        device.setPaced(false);
        SerialDeviceFactory.add(device);
        SerialDeviceFactory.add(user);
        device.open();
        device.listen(new BytesListener(bytes -> {
            synchronized (received) {
                received.write(bytes, 0, bytes.length);
                received.notifyAll();
            }
        }));
    }

    @After
    public void unplug() {
        exports.close();
        SerialDeviceFactory.remove(device);
        SerialDeviceFactory.remove(user);
    }

    private byte[] awaitDevice(int count) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        synchronized (received) {
            while (received.size() < count && System.nanoTime() < end) {
                received.wait(50);
            }
            return received.toByteArray();
        }
    }

    private static byte[] all() {
        byte[] bytes = new byte[256];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) i;
        }
        return bytes;
    }

    @Test
    public void aPseudoTerminalPassesEveryByteValueBothWays() throws Exception {
        String path = exports.terminal("/dev/test_user", null);
        try (RandomAccessFile client = new RandomAccessFile(path, "rw")) {
            client.write(all());
            assertArrayEquals(all(), awaitDevice(256));
            device.write(all());
            byte[] read = new byte[256];
            client.readFully(read);
            assertArrayEquals(all(), read);
        }
    }

    @Test
    public void aProgramMayCloseThePseudoTerminalAndOpenItAgain() throws Exception {
        String path = exports.terminal("/dev/test_user", null);
        for (int round = 1; round <= 3; round++) {
            try (RandomAccessFile client = new RandomAccessFile(path, "rw")) {
                client.write(round);
                assertEquals(round, awaitDevice(round).length);
                device.write(round);
                assertEquals(round, client.read());
            }
        }
        assertTrue(host.errors.isEmpty());
    }

    @Test
    public void aDeviceWithoutReaderIsNotBlocked() throws Exception {
        exports.terminal("/dev/test_user", null);
        for (int i = 0; i < 1000; i++) {
            device.write(all());
        }
        assertTrue(user.awaitHanded(TimeUnit.SECONDS.toMillis(60)));
    }

    @Test
    public void bytesForAClosedPseudoTerminalAreDropped() throws Exception {
        Assume.assumeTrue("macOS needs a side kept open", System.getProperty("os.name").equals("Linux"));
        String path = exports.terminal("/dev/test_user", null);
        for (int round = 1; round <= 3; round++) {
            for (int i = 0; i < 100; i++) {
                device.write(new byte[] {99});
            }
            assertTrue(user.awaitHanded(TimeUnit.SECONDS.toMillis(60)));
            try (RandomAccessFile client = new RandomAccessFile(path, "rw")) {
                client.write(round);
                awaitDevice(round);
                device.write(round);
                assertEquals("round " + round, round, client.read());
                device.write(all());
                assertTrue("left unread", user.awaitHanded(TimeUnit.SECONDS.toMillis(60)));
            }
            awaitClosed(path);
        }
    }

    /** Waits until the export has noticed that the program has gone; written and unread bytes are then dropped. */
    private void awaitClosed(String path) throws Exception {
        long end = System.nanoTime() + PATIENCE;
        int waiting = 1;
        while (waiting > 0 && System.nanoTime() < end) {
            Process count = new ProcessBuilder("python3", "-c", "import fcntl, os, struct, sys, termios\n"
                + "fd = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)\n"
                + "print(struct.unpack('i', fcntl.ioctl(fd, termios.FIONREAD, b'0000'))[0])\n", path).start();
            waiting = Integer.parseInt(new String(count.getInputStream().readAllBytes(), StandardCharsets.US_ASCII)
                .trim());
        }
        assertEquals("bytes for the next program", 0, waiting);
    }

    @Test
    public void theSettingsOfAPseudoTerminalSurviveWhileItIsClosed() throws Exception {
        int[] baud = listenToBaud();
        String path = exports.terminal("/dev/test_user", null);
        assertEquals(0, new ProcessBuilder("stty", "-F", path, "19200").inheritIO().start().waitFor());
        awaitBaud(19200, baud);
        Process told = new ProcessBuilder("stty", "-F", path, "-a").start();
        String settings = new String(told.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
        assertTrue(settings, settings.contains("speed 19200 baud") && settings.contains("-echo ")
            && settings.contains("-icanon"));
    }

    @Test
    public void aProgramFasterThanTheDeviceIsBlockedAndLosesNothing() throws Exception {
        CountDownLatch go = new CountDownLatch(1);
        device.close();
        device.open();
        device.listen(new BytesListener(bytes -> {
            try {
                go.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            synchronized (received) {
                received.write(bytes, 0, bytes.length);
                received.notifyAll();
            }
        }));
        byte[] flood = new byte[64 * 1024];
        new Random(5).nextBytes(flood);
        int number = exports.tcp("/dev/test_user", 0);
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
            client.getOutputStream().write(flood);
            long end = System.nanoTime() + PATIENCE;
            while (device.getPending() < VirtualSerialPort.BUFFER && System.nanoTime() < end) {
                assertTrue(device.getPending() <= VirtualSerialPort.BUFFER);
                synchronized (received) {
                    received.wait(10);
                }
            }
            assertEquals("a full buffer", VirtualSerialPort.BUFFER, device.getPending());
            go.countDown();
            assertArrayEquals(flood, awaitDevice(flood.length));
        }
    }

    @Test
    public void aWriterOfAClosedExportIsNotBlocked() throws Exception {
        CountDownLatch never = new CountDownLatch(1);
        device.close();
        device.open();
        device.listen(new BytesListener(bytes -> {
            try {
                never.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }));
        int number = exports.tcp("/dev/test_user", 0);
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
            client.getOutputStream().write(new byte[3 * VirtualSerialPort.BUFFER]);
            long end = System.nanoTime() + PATIENCE;
            while (device.getPending() < VirtualSerialPort.BUFFER && System.nanoTime() < end) {
                synchronized (received) {
                    received.wait(10);
                }
            }
            exports.close();
            assertTrue("the server ends", isEnded(client));
        } finally {
            never.countDown();
        }
    }

    /** Returns whether the server has closed the connection, which is a reset if bytes of the program were unread. */
    private static boolean isEnded(Socket client) throws IOException {
        try {
            return client.getInputStream().read() < 0;
        } catch (SocketException e) {
            return true;
        }
    }

    @Test
    public void aLinkGivesItAStableNameAndIsRemoved() throws Exception {
        Path link = temporary.getRoot().toPath().resolve("roomba");
        assertEquals(link.toString(), exports.terminal("/dev/test_user", link.toString()));
        assertTrue(Files.isSymbolicLink(link));
        exports.close();
        assertFalse(Files.exists(link, LinkOption.NOFOLLOW_LINKS));
    }

    @Test
    public void anOrdinaryFileIsNotReplacedByALink() throws Exception {
        Path file = temporary.newFile("precious").toPath();
        try {
            exports.terminal("/dev/test_user", file.toString());
            fail("overwrote a file");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("exists and is not a link to a pseudo-terminal"));
        }
        assertTrue(Files.isRegularFile(file));
        assertTrue("nothing is left", exports.list().isEmpty() && !user.isOpen());
    }

    @Test
    public void theRateThatAProgramSetsReachesThePort() throws Exception {
        int[] baud = listenToBaud();
        String path = exports.terminal("/dev/test_user", null);
        assertEquals(0, new ProcessBuilder("stty", "-F", path, "19200").inheritIO().start().waitFor());
        awaitBaud(19200, baud);
        assertEquals(0, new ProcessBuilder("stty", "-F", path, "300").inheritIO().start().waitFor());
        awaitBaud(300, baud);
    }

    private int[] listenToBaud() {
        int[] baud = {-1};
        user.setBaudListener(rate -> {
            synchronized (baud) {
                baud[0] = rate;
                baud.notifyAll();
            }
        });
        return baud;
    }

    private static void awaitBaud(int expected, int[] baud) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        synchronized (baud) {
            while (baud[0] != expected && System.nanoTime() < end) {
                baud.wait(50);
            }
            assertEquals(expected, baud[0]);
        }
    }

    /** Linux has no code for 14400 and 28800 baud; programs set them by ioctl TCSETS2, as pyserial does. */
    @Test
    public void aRateForWhichTheSystemHasNoCodeReachesThePort() throws Exception {
        Assume.assumeTrue("TCSETS2 is Linux's", System.getProperty("os.name").equals("Linux"));
        int[] baud = listenToBaud();
        String set = "import fcntl, os, struct, sys\n"
            + "fd = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)\ntermios2 = bytearray(44)\n"
            + "fcntl.ioctl(fd, 0x802C542A, termios2)\n"
            + "struct.pack_into('I', termios2, 8, struct.unpack_from('I', termios2, 8)[0] & ~0x100F | 0x1000)\n"
            + "struct.pack_into('II', termios2, 36, 14400, 14400)\nfcntl.ioctl(fd, 0x402C542B, termios2)\n";
        String path = exports.terminal("/dev/test_user", null);
        assertEquals(0, new ProcessBuilder("python3", "-c", set, path).inheritIO().start().waitFor());
        awaitBaud(14400, baud);
    }

    @Test
    public void aTcpPortPassesBytesBothWaysAndTakesTheNextProgram() throws Exception {
        int number = exports.tcp("/dev/test_user", 0);
        for (int round = 1; round <= 2; round++) {
            try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
                client.getOutputStream().write(("round " + round).getBytes(StandardCharsets.US_ASCII));
                assertEquals(7 * round, awaitDevice(7 * round).length);
                device.write(all());
                InputStream in = client.getInputStream();
                assertArrayEquals(all(), in.readNBytes(256));
            }
        }
    }

    @Test
    public void terminalAndTcpShareAPort() throws Exception {
        String path = exports.terminal("/dev/test_user", null);
        int number = exports.tcp("/dev/test_user", 0);
        try (RandomAccessFile terminal = new RandomAccessFile(path, "rw"); Socket socket =
            new Socket(InetAddress.getLoopbackAddress(), number)) {
            socket.getOutputStream().write(1);
            awaitDevice(1);
            terminal.write(2);
            assertArrayEquals(new byte[] {1, 2}, awaitDevice(2));
        }
    }

    @Test
    public void onlyLinksToPseudoTerminalsAreReplacedAndOnlyItsOwnRemoved() throws Exception {
        Path file = temporary.newFile("precious").toPath();
        Path other = Files.createSymbolicLink(temporary.getRoot().toPath().resolve("other"), file);
        assertThrows(IOException.class, () -> exports.terminal("/dev/test_user", other.toString()));
        assertEquals(file, Files.readSymbolicLink(other));
        Path left = Files.createSymbolicLink(temporary.getRoot().toPath().resolve("left"), Paths.get("/dev/pts/99999"));
        assertEquals(left.toString(), exports.terminal("/dev/test_user", left.toString()));
        assertFalse(Files.readSymbolicLink(left).toString().contains("99999"));
        Files.delete(left);
        Files.createSymbolicLink(left, file);
        exports.close();
        assertEquals("another's now", file, Files.readSymbolicLink(left));
        assertTrue(Files.exists(file));
    }

    @Test
    public void repeatedExportsAreTheSame() throws Exception {
        String link = temporary.getRoot().toPath().resolve("link").toString();
        assertEquals(exports.terminal("/dev/test_user", null), exports.terminal("/dev/test_user", null));
        assertEquals(link, exports.terminal("/dev/test_user", link));
        assertEquals(link, exports.terminal("/dev/test_user", link));
        int number = exports.tcp("/dev/test_user", 0);
        assertEquals(number, exports.tcp("/dev/test_user", 0));
        assertNotEquals(number, exports.rfc2217("/dev/test_user", 0));
        assertEquals(4, exports.list().get("/dev/test_user").size());
    }

    @Test
    public void anExportWithoutPortStaysAndIsSilent() throws Exception {
        SerialDeviceFactory.remove(user);
        Path link = temporary.getRoot().toPath().resolve("early");
        exports.terminal("/dev/test_user", link.toString());
        int number = exports.tcp("/dev/test_user", 0);
        try (RandomAccessFile client = new RandomAccessFile(link.toFile(), "rw");
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), number)) {
            for (int round = 1; round <= 3; round++) {
                client.write(new byte[FLOOD]);
                VirtualSerialPort again = new VirtualSerialPort("/dev/test_user");
                VirtualSerialPort.makeNullModem(device, again);
                SerialDeviceFactory.add(again);
                exports.terminal("/dev/test_user", link.toString());
                client.write(round);
                awaitLast(round);
                socket.getOutputStream().write(100 + round);
                awaitLast(100 + round);
                device.write(round);
                assertEquals(round, client.read());
                exports.pause();
                SerialDeviceFactory.remove(again);
                assertTrue(Files.isSymbolicLink(link));
            }
        }
        exports.end("/dev/test_user");
        assertFalse(Files.exists(link, LinkOption.NOFOLLOW_LINKS));
        try {
            exports.end("/dev/test_user");
            fail("ended twice");
        } catch (IllegalArgumentException e) {
            assertEquals("port \"/dev/test_user\" is not exported, legal: none", e.getMessage());
        }
    }

    /** Waits for the last byte; of the bytes written without a port, only the system's buffer remains. */
    private void awaitLast(int expected) throws Exception {
        long end = System.nanoTime() + PATIENCE;
        synchronized (received) {
            while ((received.size() == 0 || received.toByteArray()[received.size() - 1] != expected)
                && System.nanoTime() < end) {
                received.wait(50);
            }
            assertEquals(expected, received.toByteArray()[received.size() - 1]);
            assertTrue(received.size() + " of " + FLOOD, received.size() < FLOOD / 2);
            received.reset();
        }
    }

    @Test
    public void exportsHaveSeparateBaudRates() throws Exception {
        int[] baud = listenToBaud();
        String path = exports.terminal("/dev/test_user", null);
        int raw = exports.tcp("/dev/test_user", 0);
        int rfc2217 = exports.rfc2217("/dev/test_user", 0);
        assertEquals(0, new ProcessBuilder("stty", "-F", path, "19200").inheritIO().start().waitFor());
        awaitBaud(19200, baud);
        try (Socket first = new Socket(InetAddress.getLoopbackAddress(), raw)) {
            awaitBaud(0, baud);
            try (Socket second = new Socket(InetAddress.getLoopbackAddress(), rfc2217)) {
                second.getOutputStream().write(Bytes.bytes("FF FA 2C 01 00 00 25 80 FF F0"));
                awaitBaud(9600, baud);
                first.getOutputStream().write(1);
                awaitBaud(0, baud);
                second.getOutputStream().write(2);
                awaitBaud(9600, baud);
            }
            awaitBaud(0, baud);
            try (RandomAccessFile client = new RandomAccessFile(path, "rw")) {
                client.write(3);
                awaitBaud(19200, baud);
            }
            awaitBaud(0, baud);
        }
    }

    @Test
    public void programsWithoutASetRateGetTheDevices() throws Exception {
        PseudoTerminal terminal = PseudoTerminal.open("/dev/test_user", null);
        try {
            terminal.deviceAt(57600);
            assertEquals("57600", speed(terminal.getPath()));
            terminal.deviceAt(9600);
            assertEquals("9600", speed(terminal.getPath()));
            assertEquals(0, new ProcessBuilder("stty", "-F", terminal.getPath(), "19200").inheritIO().start()
                .waitFor());
            terminal.deviceAt(57600);
            assertEquals("set by a program", "19200", speed(terminal.getPath()));
        } finally {
            terminal.close();
        }
    }

    /** On the real robot, a driver that does not follow its device's new rate gets no answer. */
    @Test
    public void settingTheCurrentRateCounts() throws Exception {
        Assume.assumeTrue("macOS doesn't tell it", System.getProperty("os.name").equals("Linux"));
        int[] baud = listenToBaud();
        String path = exports.terminal("/dev/test_user", null);
        assertEquals("50", speed(path));
        try (RandomAccessFile client = new RandomAccessFile(path, "rw")) {
            client.write(1);
            awaitDevice(1);
            assertEquals("who sets nothing has set nothing", -1, baud[0]);
            assertEquals(0, new ProcessBuilder("stty", "-F", path, "50").inheritIO().start().waitFor());
            awaitBaud(50, baud);
        }
    }

    @Test
    public void aProgramThatReadsLinesGetsThem() throws Exception {
        Assume.assumeTrue("macOS does nothing of it", System.getProperty("os.name").equals("Linux"));
        String path = exports.terminal("/dev/test_user", null);
        assertEquals(0, new ProcessBuilder("stty", "-F", path, "9600", "icanon").inheritIO().start().waitFor());
        try (RandomAccessFile client = new RandomAccessFile(path, "rw")) {
            client.write(1);
            awaitDevice(1);
            device.write("$GP".getBytes(StandardCharsets.US_ASCII));
            assertTrue(user.awaitHanded(TimeUnit.SECONDS.toMillis(60)));
            device.write("GGA\n$GPR".getBytes(StandardCharsets.US_ASCII));
            byte[] read = new byte[256];
            assertEquals("$GPGGA\n", new String(read, 0, client.read(read), StandardCharsets.US_ASCII));
        }
    }

    private static String speed(String path) throws Exception {
        Process told = new ProcessBuilder("stty", "-F", path, "speed").start();
        return new String(told.getInputStream().readAllBytes(), StandardCharsets.US_ASCII).trim();
    }

    @Test
    public void aTcpProgramThatReadsNothingLosesWholeMessagesAndBlocksNoOther() throws Exception {
        int number = exports.rfc2217("/dev/test_user", 0);
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
            client.getOutputStream().write(1);
            awaitDevice(1);
            for (int i = 0; i < 100_000; i++) {
                device.write(new byte[] {(byte) 255, 7, (byte) 255, 8});
            }
            assertTrue(user.awaitHanded(TimeUnit.SECONDS.toMillis(60)));
            client.setSoTimeout(1000);
            byte[] read = readAll(client.getInputStream());
            assertTrue(read.length > 0);
            assertEquals("whole messages", 0, read.length % 6);
            for (int i = 0; i < read.length; i += 6) {
                assertArrayEquals(Bytes.bytes("FF FF 07 FF FF 08"), java.util.Arrays.copyOfRange(read, i, i + 6));
            }
        }
    }

    private static byte[] readAll(InputStream in) throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        byte[] buffer = new byte[65536];
        try {
            for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
                all.write(buffer, 0, n);
            }
        } catch (SocketTimeoutException e) {
            return all.toByteArray();
        }
        return all.toByteArray();
    }

    @Test
    public void aPortInUseIsNotExported() throws Exception {
        SerialDataListener other = new BytesListener(bytes -> { });
        user.open();
        user.listen(other);
        try {
            exports.tcp("/dev/test_user", 0);
            fail("two owners");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("in use within MyRobotLab"));
        }
    }

    @Test
    public void aSimulatedDeviceIsReachedWithoutThreadHandOvers() throws Exception {
        PortBridge bridge = new PortBridge("/dev/test_user", host);
        TcpEndpoint server = TcpEndpoint.open("/dev/test_user", TcpSession.RAW, 0);
        String[] writer = new String[1];
        SerialLine.Sink[] reader = new SerialLine.Sink[1];
        CountDownLatch hungUp = new CountDownLatch(1);
        bridge.attach(user, new ExternalLine() {
            @Override
            public void write(byte[] bytes) {
                synchronized (received) {
                    writer[0] = Thread.currentThread().getName();
                    received.write(bytes, 0, bytes.length);
                    received.notifyAll();
                }
            }

            @Override
            public void setReader(SerialLine.Sink newReader) {
                reader[0] = newReader;
            }

            @Override
            public void pickUp() {
                // nothing to do
            }

            @Override
            public void hangUp() {
                hungUp.countDown();
            }

            @Override
            public int getDeviceBaud() {
                return 9600;
            }
        });
        bridge.add(server);
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), server.getNumber())) {
            client.getOutputStream().write(all());
            assertArrayEquals(all(), awaitDevice(256));
            assertEquals("TCP server of /dev/test_user", writer[0]);
            reader[0].receive(all(), new int[] {0});
            assertArrayEquals("sent by the calling thread", all(), client.getInputStream().readNBytes(256));
            assertEquals("a program has it", 1, hungUp.getCount());
        }
        assertTrue("the device is told that the program has gone", hungUp.await(60, TimeUnit.SECONDS));
        bridge.close();
        assertNull("the device's bytes take the other way again", reader[0]);
    }
}
