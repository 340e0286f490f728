// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.websockets.core.StreamSourceFrameChannel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import org.xnio.ChannelListener;
import org.xnio.IoUtils;

/**
 * Reads a text message of a web socket and passes it on when complete. Limits its length while fragments arrive;
 * Undertow's own buffer checks the length only at the end. The connection's own thread.
 */
final class TextReader implements ChannelListener<StreamSourceFrameChannel> {
    private static final int PIECE = 1 << 13;

    private final ByteBuffer piece = ByteBuffer.allocate(PIECE);
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final int longest;
    private final Consumer<String> taker;
    /** Whether the text is complete or the web socket is closed. */
    private boolean isDone;

    private TextReader(int longest, Consumer<String> taker) {
        this.longest = longest;
        this.taker = taker;
    }

    /**
     * Reads a text as it arrives.
     *
     * @param longest bytes; a longer text closes the web socket
     */
    static void read(StreamSourceFrameChannel text, int longest, Consumer<String> taker) {
        TextReader reader = new TextReader(longest, taker);
        text.getReadSetter().set(reader);
        reader.handleEvent(text);
        if (!reader.isDone) {
            text.resumeReads();
        }
    }

    @Override
    public void handleEvent(StreamSourceFrameChannel text) {
        if (isDone) {
            text.suspendReads();
            return;
        }
        try {
            int length = text.read(piece);
            while (length > 0 && bytes.size() + length <= longest) {
                bytes.write(piece.array(), 0, length);
                piece.clear();
                length = text.read(piece);
            }
            if (length > 0) {
                close(text);
            } else if (length < 0) {
                isDone = true;
                taker.accept(bytes.toString(StandardCharsets.UTF_8));
            }
        } catch (IOException e) {
            close(text);
        }
    }

    /** Suspends reads: Undertow calls the reader of unread bytes repeatedly, even after its web socket is closed. */
    private void close(StreamSourceFrameChannel text) {
        isDone = true;
        text.suspendReads();
        IoUtils.safeClose(text.getWebSocketChannel());
    }
}
