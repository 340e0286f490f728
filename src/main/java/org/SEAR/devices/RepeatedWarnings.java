// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.HashMap;
import java.util.Map;

/**
 * Limits repeated warnings of one cause: the first one passes, further ones are counted, and the count is reported at
 * 10, 100, 1000 and so on. One thread at a time.
 */
public final class RepeatedWarnings {
    private static final int STEP = 10;

    private final Map<String, Long> counts = new HashMap<>();

    /**
     * Counts a warning.
     *
     * @param cause key of warnings that are counted together
     * @return the text to show now; null for none
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

    /** Clears all counts. */
    public void clear() {
        counts.clear();
    }
}
