// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.io.ByteArrayOutputStream;

/** Bytes that a device sends during a step of lock-step, held until its port's turn. Any thread. */
final class PendingBytes {
    private static final byte[] NOTHING = {};

    private final ByteArrayOutputStream waiting = new ByteArrayOutputStream();
    private boolean stepping;

    /** @param on whether a step is in progress */
    synchronized void setStepping(boolean on) {
        stepping = on;
    }

    /**
     * Holds the bytes if a step is in progress.
     *
     * @return whether it holds them; otherwise send the held bytes first
     */
    synchronized boolean keep(byte[] bytes) {
        if (stepping) {
            waiting.write(bytes, 0, bytes.length);
        }
        return stepping;
    }

    /** Removes and returns the held bytes. */
    synchronized byte[] take() {
        if (waiting.size() == 0) {
            return NOTHING;
        }
        byte[] taken = waiting.toByteArray();
        waiting.reset();
        return taken;
    }
}
