// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.Slow;
import org.SEAR.devices.SerialLine;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.run.ExternalLine;

/** The access server compared with byte sequences of RFC 854 and RFC 2217. */
@Category(Slow.class)
public class Rfc2217Test {
    private static final int BAUD = 9600;

    private final VirtualSerialPort device = new VirtualSerialPort("/dev/test_uart");
    private final VirtualSerialPort user = new VirtualSerialPort("/dev/test_user");
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();
    private final ByteArrayOutputStream replies = new ByteArrayOutputStream();
    private final RecordingHost host = new RecordingHost();
    private final PortBridge bridge = new PortBridge("/dev/test_user", host);
    private final Rfc2217 session = new Rfc2217(new LineEnd(bridge, null), replies::writeBytes);
    private volatile int baud;

    @Before
    public void plugIn() throws IOException {
        VirtualSerialPort.makeNullModem(device, user);
        user.setBaudListener(rate -> baud = rate);
        bridge.attach(user, new ExternalLine() {
            @Override
            public void write(byte[] bytes) {
                heard.writeBytes(bytes);
            }

            @Override
            public void setReader(SerialLine.Sink reader) {
                // the device sends nothing
            }

            @Override
            public void pickUp() {
                // nothing to do
            }

            @Override
            public void hangUp() {
                // the device has a cable
            }

            @Override
            public int getDeviceBaud() {
                return BAUD;
            }
        });
    }

    @After
    public void unplug() {
        bridge.close();
    }

    private String answer(String hex) {
        replies.reset();
        session.received(Bytes.bytes(hex));
        return Bytes.hex(replies.toByteArray());
    }

    private String heard() {
        return Bytes.hex(heard.toByteArray());
    }

    @Test
    public void theBaudRateIsSetAndQueried() {
        assertEquals("FF FA 2C 65 00 00 25 80 FF F0", answer("FF FA 2C 01 00 00 00 00 FF F0"));
        assertEquals("the device's own", 0, baud);
        assertEquals("FF FA 2C 65 00 01 C2 00 FF F0", answer("FF FA 2C 01 00 01 C2 00 FF F0"));
        assertEquals(115200, baud);
        assertEquals("FF FA 2C 65 00 01 C2 00 FF F0", answer("FF FA 2C 01 00 00 00 00 FF F0"));
        assertEquals("a rate with a byte 255", "FF FA 2C 65 00 00 FF FF 00 FF F0",
            answer("FF FA 2C 01 00 00 FF FF 00 FF F0"));
        assertEquals(0xFF00, baud);
        assertEquals("none of a line", "FF FA 2C 65 00 00 FF FF 00 FF F0",
            answer("FF FA 2C 01 7F FF FF FF FF FF FF FF F0"));
        assertEquals(0xFF00, baud);
    }

    @Test
    public void rawBytesAreReportedOnceAndPass() {
        answer("02 00 01 00 31 15 12");
        assertEquals("[]", host.warnings.toString());
        answer("02 00 01 00 31 15 12");
        answer("02 00 01 00 31 15 12");
        assertEquals("[export of /dev/test_user: 14 bytes arrived without RFC 2217 negotiation: is it the right port? "
            + "A program that sends raw bytes needs exportTcp]", host.warnings.toString());
        assertEquals("02 00 01 00 31 15 12 02 00 01 00 31 15 12 02 00 01 00 31 15 12", heard());
    }

    @Test
    public void optionsAreNegotiatedWithoutEnd() {
        assertEquals("binary both ways", "FF FD 00 FF FB 00", answer("FF FB 00 FF FD 00"));
        assertEquals("agreed already", "", answer("FF FB 00 FF FD 00"));
        assertEquals("with the state of the modem lines", "FF FD 2C FF FA 2C 6B B0 FF F0", answer("FF FB 2C"));
        assertEquals("FF FB 2C", answer("FF FD 2C"));
        assertEquals("no echo, no terminal type", "FF FC 01 FF FE 18", answer("FF FD 01 FF FB 18"));
        assertEquals("FF FC 00 FF FE 00", answer("FF FE 00 FF FC 00"));
        assertEquals("off already", "", answer("FF FE 00 FF FC 00 FF FE 01"));
    }

    @Test
    public void theLineIsAlways8N1() {
        assertEquals("FF FA 2C 66 08 FF F0", answer("FF FA 2C 02 07 FF F0"));
        assertEquals("FF FA 2C 67 01 FF F0", answer("FF FA 2C 03 03 FF F0"));
        assertEquals("FF FA 2C 68 01 FF F0", answer("FF FA 2C 04 02 FF F0"));
    }

    @Test
    public void dtrAndRtsAreAcceptedAndAcknowledged() {
        assertEquals("no handshake", "FF FA 2C 69 01 FF F0", answer("FF FA 2C 05 03 FF F0"));
        assertEquals("on at first", "FF FA 2C 69 08 FF F0", answer("FF FA 2C 05 07 FF F0"));
        assertEquals("FF FA 2C 69 09 FF F0", answer("FF FA 2C 05 09 FF F0"));
        assertEquals("FF FA 2C 69 09 FF F0", answer("FF FA 2C 05 07 FF F0"));
        assertEquals("FF FA 2C 69 0C FF F0", answer("FF FA 2C 05 0C FF F0"));
        assertEquals("FF FA 2C 69 0C FF F0", answer("FF FA 2C 05 0A FF F0"));
        assertEquals("no break", "FF FA 2C 69 06 FF F0", answer("FF FA 2C 05 04 FF F0"));
    }

    @Test
    public void masksAndPurgesAreAcknowledgedAndTheServerHasAName() {
        assertEquals("FF FA 2C 6F FF FF FF F0 FF FA 2C 6B B0 FF F0", answer("FF FA 2C 0B FF FF FF F0"));
        assertEquals("FF FA 2C 6E 00 FF F0", answer("FF FA 2C 0A 00 FF F0"));
        assertEquals("FF FA 2C 70 03 FF F0", answer("FF FA 2C 0C 03 FF F0"));
        assertEquals("FF FA 2C 64 53 45 41 52 FF F0", answer("FF FA 2C 00 FF F0"));
        assertEquals("another option's, too short, too long, unknown: nothing", "",
            answer("FF FA 18 01 FF F0 FF FA 2C FF F0 FF FA FF F0"
            + " FF FA 2C 01 00 FF F0 FF FA 2C 01 00 00 25 80 00 FF F0 FF FA 2C 63 01 FF F0"));
    }

    @Test
    public void dataPassWithTheByte255Doubled() {
        assertEquals("", answer("01 FF FF 02 FF F1 03"));
        assertEquals("01 FF 02 03", heard());
        assertEquals("02 FF FF 0D 0A", Bytes.hex(session.encode(Bytes.bytes("02 FF 0D 0A"))));
        answer("04 FF");
        answer("FA 2C 01 00 00 4B");
        answer("00 FF");
        answer("F0 05");
        assertEquals("in pieces", "01 FF 02 03 04 05", heard());
        assertEquals(19200, baud);
    }

    @Test
    public void noInputBlocksOrFillsIt() {
        Random random = new Random(Fuzz.SEED);
        byte[] piece = new byte[1000];
        for (int done = 0; done < Fuzz.BYTES; done += piece.length) {
            random.nextBytes(piece);
            for (int i = 0; i < piece.length; i++) {
                piece[i] = random.nextInt(3) == 0 ? new byte[] {(byte) 255, (byte) 250, (byte) 240, 44, 1,
                    (byte) 253}[random.nextInt(6)] : piece[i];
            }
            replies.reset();
            session.received(piece);
            assertTrue("no flood of answers", replies.size() < 10 * piece.length);
            heard();
            heard.reset();
        }
        answer("00 FF F0 FF F0");
        session.received(new byte[1 << 20]);
        answer("FF F0 FF F0");
        heard();
        heard.reset();
        assertEquals("FF FA 2C 65 00 00 25 80 FF F0", answer("FF FA 2C 01 00 00 25 80 FF F0"));
        assertEquals("", answer("2A"));
        assertEquals("2A", heard());
        assertArrayEquals(new byte[0], session.encode(new byte[0]));
    }
}
