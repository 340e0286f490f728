package org.SEAR.devices;

import java.util.HashMap;
import java.util.Map;

/**
 * Keeps warnings of one cause from becoming a flood: the first is told as it is, further ones are counted, and the count is told at 10, 100, 1000 and
 * so on. One thread at a time.
 */
public final class RepeatedWarnings {
    private static final int STEP = 10;

    private final Map<String, Long> counts = new HashMap<>();

    /**
     * Counts a warning.
     *
     * @param cause what the warnings have in common that are counted together
     * @return what to tell now; null for nothing
     */
    public String count(String cause, String message) {
        long count = counts.merge(cause, 1L, Long::sum);
        if (count == 1) {
            return message;
        }
        return isPowerOfTen(count) ? message + " (" + count + " times so far)" : null;
    }

    private static boolean isPowerOfTen(long count) {
        long rest = count;
        while (rest % STEP == 0) {
            rest /= STEP;
        }
        return rest == 1;
    }

    /** Begins anew. */
    public void clear() {
        counts.clear();
    }
}
