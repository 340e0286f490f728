// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.sun.jna.Library;
import com.sun.jna.Native;
import java.util.Arrays;
import java.util.Random;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;

/** The Serial service on a port of the operating system: a pseudo-terminal, which jssc treats like a real port. */
@Category(Slow.class)
public class PseudoTerminalTest {
    private static final int O_RDWR = 2;
    private static final int O_NOCTTY = 0x100;
    private static final int PIECE = 512;

    private Serial serial;
    private int master;
    private String name;

    /** The C library. */
    public interface C extends Library {
        C LIBRARY = Native.load("c", C.class);

        int posix_openpt(int flags);

        int grantpt(int file);

        int unlockpt(int file);

        String ptsname(int file);

        long read(int file, byte[] into, long size);

        long write(int file, byte[] from, long size);

        int close(int file);
    }

    @Before
    public void open() {
        serial = (Serial) Runtime.start("serial", "Serial");
        master = C.LIBRARY.posix_openpt(O_RDWR | O_NOCTTY);
        assertTrue("this machine has no pseudo-terminals", master >= 0);
        assertEquals(0, C.LIBRARY.grantpt(master));
        assertEquals(0, C.LIBRARY.unlockpt(master));
        name = C.LIBRARY.ptsname(master);
    }

    @After
    public void release() {
        Runtime.releaseAll();
        C.LIBRARY.close(master);
    }

    @Test(timeout = 300_000)
    public void bytesOfEveryValueGoBothWays() throws Exception {
        serial.connect(name, 57600, 8, 1, 0);
        assertTrue(String.valueOf(serial.getLastError()), serial.isConnected());
        byte[] all = new byte[20 * PIECE];
        new Random(3).nextBytes(all);
        serial.setTimeout(60_000);
        for (int at = 0; at < all.length; at += PIECE) {
            byte[] piece = Arrays.copyOfRange(all, at, at + PIECE);
            assertEquals(PIECE, C.LIBRARY.write(master, piece, PIECE));
            assertArrayEquals(piece, serial.read(PIECE));
            serial.write(piece);
            assertArrayEquals(piece, fromMaster());
        }
        serial.disconnect();
        assertFalse(serial.isConnected());
        serial.connect(name, 9600, 8, 1, 0);
        assertTrue(String.valueOf(serial.getLastError()), serial.isConnected());
    }

    private byte[] fromMaster() {
        byte[] whole = new byte[PIECE];
        int count = 0;
        while (count < PIECE) {
            byte[] part = new byte[PIECE - count];
            int n = (int) C.LIBRARY.read(master, part, part.length);
            assertTrue("the pseudo-terminal is closed", n > 0);
            System.arraycopy(part, 0, whole, count, n);
            count += n;
        }
        return whole;
    }
}
