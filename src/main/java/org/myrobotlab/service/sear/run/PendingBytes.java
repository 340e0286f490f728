package org.myrobotlab.service.sear.run;

import java.io.ByteArrayOutputStream;

/** What a device sends while a step of lock-step is made: it waits until it is its port's turn. Any thread. */
final class PendingBytes {
    private static final byte[] NOTHING = {};

    private final ByteArrayOutputStream waiting = new ByteArrayOutputStream();
    private boolean stepping;

    /** @param on whether a step is being made */
    synchronized void setStepping(boolean on) {
        stepping = on;
    }

    /**
     * Keeps bytes that come in a step.
     *
     * @return whether it has; if not, what waits goes before them
     */
    synchronized boolean keep(byte[] bytes) {
        if (stepping) {
            waiting.write(bytes, 0, bytes.length);
        }
        return stepping;
    }

    /** What waits, and waits no more; empty for nothing. */
    synchronized byte[] take() {
        if (waiting.size() == 0) {
            return NOTHING;
        }
        byte[] taken = waiting.toByteArray();
        waiting.reset();
        return taken;
    }
}
