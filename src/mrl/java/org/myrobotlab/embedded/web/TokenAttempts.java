package org.myrobotlab.embedded.web;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/** Wrong tokens, counted for each address that they come from. Any thread. */
final class TokenAttempts {
    /** Wrong ones in a window after which an address has to wait. */
    static final int MOST = 10;
    static final int WINDOW_SECONDS = 60;
    /** Addresses that are remembered; the oldest is forgotten first. */
    private static final int ADDRESSES = 1000;
    /** Of an IPv6 address, what a network gives to one house or computer. */
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

    /** When the window of an address began and how many wrong ones it has; a new one where there is none that goes on. */
    private long[] window(InetAddress address) {
        long[] window = windows.get(key(address));
        boolean goesOn = window != null && nanos.getAsLong() - window[0] < TimeUnit.SECONDS.toNanos(WINDOW_SECONDS);
        return goesOn ? window : new long[] {nanos.getAsLong(), 0};
    }

    /** Whether an address has to wait until its window has passed. */
    synchronized boolean isOver(InetAddress address) {
        return window(address)[1] >= MOST;
    }

    /**
     * One more wrong one.
     *
     * @return whether this is the one after which the address has to wait
     */
    synchronized boolean count(InetAddress address) {
        long[] window = window(address);
        window[1]++;
        windows.remove(key(address));
        windows.put(key(address), window);
        return window[1] == MOST;
    }
}
