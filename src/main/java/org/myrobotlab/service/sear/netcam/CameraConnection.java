// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;

/**
 * A connection with one request and one response. Holds at most one picture and never waits; a slow client misses
 * pictures. Server's thread.
 */
final class CameraConnection {
    private static final int LONGEST_HEAD = 8192;
    private static final int TOO_LONG = 431;
    private static final long HEAD_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long WAITING_NANOS = TimeUnit.SECONDS.toNanos(30);
    private static final long LEAVING_NANOS = TimeUnit.SECONDS.toNanos(2);

    private final SocketChannel channel;
    private final String camera;
    private final DeviceProfile profile;
    private final int door;
    private final int port;
    private final Demand demand;
    private final long timeout;
    private final byte[] head = new byte[LONGEST_HEAD];
    private int length;
    private Stage stage = Stage.ASKING;
    private Request refusal;
    private SelectionKey key;
    private ByteBuffer[] sending;
    /** Time of the last progress, ns of the computer's clock. */
    private long since = System.nanoTime();
    private Form form;
    private long ticket;
    private long sent;

    private enum Stage { ASKING, WAITING, STREAMING, ANSWERED, LEAVING, GONE }

    /** @param patience nanoseconds without progress after which a client is dropped */
    CameraConnection(SocketChannel channel, String camera, DeviceProfile likeness, int door, int port, Demand demand,
        long patience) {
        this.channel = channel;
        this.camera = camera;
        this.profile = likeness;
        this.door = door;
        this.port = port;
        this.demand = demand;
        this.timeout = patience;
    }

    /** Sets the selection key of the channel. */
    void setKey(SelectionKey selected) {
        key = selected;
    }

    /** Sets a response for any request. */
    void refuse(Request with) {
        refusal = with;
    }

    boolean isStreaming() {
        return stage == Stage.STREAMING;
    }

    /** Returns whether it awaits no response: before its request, and after its last response. */
    boolean isIdle() {
        return stage == Stage.ASKING || stage == Stage.LEAVING;
    }

    boolean isGone() {
        return stage == Stage.GONE;
    }

    /** Handles received bytes and free space in the send buffer. */
    void ready(ByteBuffer buffer) {
        try {
            if (key.isValid() && key.isReadable()) {
                read(buffer);
            }
            if (stage != Stage.GONE && key.isValid() && key.isWritable()) {
                write();
            }
        } catch (IOException e) {
            close();
        }
    }

    private void read(ByteBuffer buffer) throws IOException {
        buffer.clear();
        int count = channel.read(buffer);
        if (count < 0) {
            ended();
        } else if (stage == Stage.ASKING) {
            int taken = Math.min(count, LONGEST_HEAD - length);
            buffer.flip().get(head, length, taken);
            int end = end(Math.max(0, length - 3), length + taken);
            length += taken;
            if (end > 0) {
                answer(refusal == null ? Request.of(head, end, port) : refusal);
            } else if (length == LONGEST_HEAD) {
                answer(Request.refused(TOO_LONG, "the request's head is longer than " + LONGEST_HEAD + " bytes"));
            }
        }
    }

    /** Closes the connection at the end of the client's bytes, unless a response is pending. */
    private void ended() {
        if (stage == Stage.WAITING || stage == Stage.ANSWERED) {
            key.interestOps(key.interestOps() & ~SelectionKey.OP_READ);
        } else {
            close();
        }
    }

    /** Returns the index after the head's empty line; 0 if it has not arrived. */
    private int end(int from, int to) {
        for (int i = from; i < to; i++) {
            if (head[i] == '\n' && (i > 0 && head[i - 1] == '\n' || i > 2 && head[i - 1] == '\r'
                && head[i - 2] == '\n')) {
                return i + 1;
            }
        }
        return 0;
    }

    private void answer(Request request) throws IOException {
        since = System.nanoTime();
        form = request.getRefusal() == 0 ? profile.at(door, request.getTarget()) : null;
        if (request.getRefusal() != 0) {
            finish(HttpReplies.refusal(request));
        } else if (form == null) {
            finish(HttpReplies.missing(request.getTarget()));
        } else if (form.isPage()) {
            finish(HttpReplies.page(camera));
        } else if (form == Form.STREAM) {
            stage = Stage.STREAMING;
            send(HttpReplies.stream(profile.getBoundary()));
        } else {
            stage = Stage.WAITING;
            ticket = demand.ask(form);
        }
    }

    private void finish(ByteBuffer[] last) throws IOException {
        stage = Stage.ANSWERED;
        send(last);
    }

    private void send(ByteBuffer[] bytes) throws IOException {
        sending = bytes;
        since = System.nanoTime();
        write();
    }

    private void write() throws IOException {
        if (sending != null && channel.write(sending) > 0) {
            since = System.nanoTime();
        }
        if (sending != null && Arrays.stream(sending).noneMatch(ByteBuffer::hasRemaining)) {
            sending = null;
            if (stage == Stage.ANSWERED) {
                channel.shutdownOutput();
                stage = Stage.LEAVING;
            }
        }
        int wanted = stage == Stage.LEAVING ? SelectionKey.OP_READ : key.interestOps() & ~SelectionKey.OP_WRITE;
        key.interestOps(sending == null ? wanted : wanted | SelectionKey.OP_WRITE);
    }

    /**
     * Sends the next picture if it is due; closes the connection after a time-out.
     *
     * @param now the computer's clock, nanoseconds
     * @param stream the newest picture of the stream
     * @param still the last response for stills
     */
    void handle(long now, Latest stream, Latest still) {
        try {
            if (stage == Stage.STREAMING && sending == null && stream.shot != null && stream.number != sent) {
                sent = stream.number;
                send(HttpReplies.part(profile.getBoundary(), stream.shot));
            } else if (stage == Stage.WAITING && still.number >= ticket) {
                finish(HttpReplies.still(camera, form, still.shot));
            }
        } catch (IOException e) {
            close();
        }
        if (now - since > limit()) {
            close();
        }
    }

    /** Returns the time-out of the present stage, ns. */
    private long limit() {
        switch (stage) {
            case ASKING:
                return HEAD_NANOS;
            case WAITING:
                return WAITING_NANOS;
            case LEAVING:
                return LEAVING_NANOS;
            default:
                return sending == null ? Long.MAX_VALUE : timeout;
        }
    }

    void close() {
        stage = Stage.GONE;
        sending = null;
        try {
            channel.close();
        } catch (IOException e) {
            PictureServer.LOG.debug("closing a connection of {} failed: {}", camera, e.toString());
        }
    }

    /** A numbered picture. Immutable. */
    static final class Latest {
        static final Latest NONE = new Latest(null, 0);
        final EncodedFrame shot;
        final long number;

        Latest(EncodedFrame shot, long number) {
            this.shot = shot;
            this.number = number;
        }
    }
}
