package org.SEAR;

import java.io.IOException;
import java.net.ServerSocket;
import java.util.concurrent.ThreadLocalRandom;

/**
 * A TCP port for a server that a test starts, perhaps again after it was killed: below those that systems give out by themselves, so that no program
 * beside gets it meanwhile. Any thread.
 */
public final class FreePort {
    private static final int FIRST = 20000;
    /** Linux gives out ports from 32768 on. */
    private static final int END = 32000;

    private FreePort() {
    }

    /** One that nobody listens at now. */
    public static int find() {
        while (true) {
            try (ServerSocket free = new ServerSocket(ThreadLocalRandom.current().nextInt(FIRST, END))) {
                return free.getLocalPort();
            } catch (IOException e) {
                // in use: another one
            }
        }
    }
}
