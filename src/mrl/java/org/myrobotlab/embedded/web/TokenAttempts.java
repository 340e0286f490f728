// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/** Counts wrong tokens by client address. Any thread. */
final class TokenAttempts {
    /** Wrong attempts in a window after which an address has to wait. */
    static final int MOST = 10;
    static final int WINDOW_SECONDS = 60;
    /** Limit of remembered addresses; the oldest is forgotten first. */
    private static final int ADDRESSES = 1000;
    /** Bytes of an IPv6 address that usually identify one household or computer. */
    private static final int PREFIX = 8;

    private final Map<String, long[]> windows = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, long[]> eldest) {
            return size() > ADDRESSES;
        }
    };
    private final LongSupplier nanos;

    /** @param nanos the clock, as {@link System#nanoTime} */
    TokenAttempts(LongSupplier nanos) {
        this.nanos = nanos;
    }

    private static String key(InetAddress address) {
        byte[] bytes = address.getAddress();
        return Arrays.toString(address instanceof Inet6Address ? Arrays.copyOf(bytes, PREFIX) : bytes);
    }

    /**
     * Returns the start of an address's window and its number of wrong attempts; a new window if the last one is over.
     */
    private long[] window(InetAddress address) {
        long[] window = windows.get(key(address));
        boolean goesOn = window != null && nanos.getAsLong() - window[0] < TimeUnit.SECONDS.toNanos(WINDOW_SECONDS);
        return goesOn ? window : new long[] {nanos.getAsLong(), 0};
    }

    /** Returns whether an address has to wait for the end of its window. */
    synchronized boolean isOver(InetAddress address) {
        return window(address)[1] >= MOST;
    }

    /**
     * Counts a wrong attempt.
     *
     * @return whether the address has to wait from now on
     */
    synchronized boolean count(InetAddress address) {
        long[] window = window(address);
        window[1]++;
        windows.remove(key(address));
        windows.put(key(address), window);
        return window[1] == MOST;
    }
}
