// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.websockets.core.StreamSourceFrameChannel;
import io.undertow.websockets.core.WebSocketChannel;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.function.ObjIntConsumer;
import org.xnio.ChannelListener;
import org.xnio.IoUtils;

/**
 * Reads the text messages of a web socket and passes each on when complete. Limits its length while fragments arrive;
 * Undertow's own buffer checks the length only at the end. The connection's own thread, except {@link #close}.
 */
final class TextReader implements ChannelListener<StreamSourceFrameChannel> {
    private static final int PIECE = 1 << 13;

    private final ByteBuffer piece = ByteBuffer.allocate(PIECE);
    private final WebSocketChannel channel;
    private final MessageRoom room;
    private final ObjIntConsumer<String> taker;
    private int length;
    /** Whether the present text is complete. */
    private boolean isDone;
    private volatile boolean isClosed;

    /**
     * @param room holds the text meanwhile; its limit of a text closes the web socket
     * @param taker gets each text with its number of bytes, for which it calls {@link MessageRoom#release}
     */
    TextReader(WebSocketChannel channel, MessageRoom room, ObjIntConsumer<String> taker) {
        this.channel = channel;
        this.room = room;
        this.taker = taker;
    }

    /** Reads a text as it arrives. */
    void read(StreamSourceFrameChannel text) {
        isDone = false;
        length = 0;
        text.getReadSetter().set(this);
        handleEvent(text);
        if (!isDone) {
            text.resumeReads();
        }
    }

    @Override
    public void handleEvent(StreamSourceFrameChannel text) {
        if (isDone || isClosed) {
            stop(text);
            return;
        }
        try {
            int count = text.read(piece);
            while (count > 0 && room.add(this, piece.array(), count)) {
                length += count;
                piece.clear();
                count = text.read(piece);
            }
            if (count < 0) {
                handOn();
            } else if (count > 0) {
                stop(text);
            }
        } catch (IOException e) {
            close();
            stop(text);
        }
    }

    private void handOn() {
        isDone = true;
        String whole = room.complete(this);
        if (whole != null) {
            taker.accept(whole, length);
        }
    }

    /** Suspends reads: Undertow calls the reader of unread bytes repeatedly, even after its web socket is closed. */
    private void stop(StreamSourceFrameChannel text) {
        isDone = true;
        text.suspendReads();
    }

    boolean isClosed() {
        return isClosed;
    }

    /** Closes the web socket and forgets an incomplete text. Any thread. */
    void close() {
        isClosed = true;
        room.drop(this);
        IoUtils.safeClose(channel);
    }
}
