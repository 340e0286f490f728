// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import java.io.IOException;
import java.net.ServerSocket;
import java.util.concurrent.ThreadLocalRandom;

/**
 * A free TCP port for a server that a test starts, possibly again after it was killed. Ports lie below the ephemeral
 * range of the system, so that no other program gets them meanwhile. Any thread.
 */
public final class FreePort {
    private static final int FIRST = 20000;
    /** Ephemeral ports begin at 32768 on Linux. */
    private static final int END = 32000;

    private FreePort() {
    }

    /** Returns a port without a listener. */
    public static int find() {
        while (true) {
            try (ServerSocket free = new ServerSocket(ThreadLocalRandom.current().nextInt(FIRST, END))) {
                return free.getLocalPort();
            } catch (IOException e) {
                // in use: try another
            }
        }
    }
}
