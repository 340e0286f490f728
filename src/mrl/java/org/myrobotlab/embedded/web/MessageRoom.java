// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Messages of all pages while they arrive or wait for their turn, in bounded memory. When it is full, the oldest
 * incomplete message is dropped and its page closed, so that idle pages lock no one out. Any thread.
 */
final class MessageRoom {
    /** Limit of all messages, bytes. */
    static final int MOST = (int) Math.min(64 << 20, Runtime.getRuntime().maxMemory() / 8);

    /** The beginning of each incomplete message, the oldest first. */
    private final Map<TextReader, ByteArrayOutputStream> incomplete = new LinkedHashMap<>();
    private int used;

    /**
     * Takes the next bytes of a page's message.
     *
     * @return whether there was room; if not, the page is closed
     */
    synchronized boolean add(TextReader page, byte[] piece, int length) {
        ByteArrayOutputStream bytes = page.isClosed() ? null
            : incomplete.computeIfAbsent(page, one -> new ByteArrayOutputStream());
        if (bytes == null || bytes.size() + length > RequestBody.LONGEST) {
            page.close();
            return false;
        }
        while (used + length > MOST) {
            TextReader oldest = incomplete.keySet().iterator().next();
            oldest.close();
            if (oldest == page) {
                return false;
            }
        }
        bytes.write(piece, 0, length);
        used += length;
        return true;
    }

    /**
     * Returns the text of a complete message, whose bytes count until {@link #release}.
     *
     * @return null if the page was closed meanwhile
     */
    synchronized String complete(TextReader page) {
        ByteArrayOutputStream bytes = incomplete.remove(page);
        return page.isClosed() ? null : bytes == null ? "" : bytes.toString(StandardCharsets.UTF_8);
    }

    /** Forgets a page's incomplete message. */
    synchronized void drop(TextReader page) {
        ByteArrayOutputStream bytes = incomplete.remove(page);
        release(bytes == null ? 0 : bytes.size());
    }

    /** Frees the room of a handled message of that many bytes. */
    synchronized void release(int bytes) {
        used -= bytes;
    }
}
