package org.myrobotlab.service.sear.netcam;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;

/**
 * A connection: one request, one answer. It holds one picture at most, and never waits; one that takes its bytes too slowly misses pictures. The
 * thread of its server.
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
    /** When it last went on, by the computer's clock in nanoseconds. */
    private long since = System.nanoTime();
    private Form form;
    private long ticket;
    private long sent;

    private enum Stage { ASKING, WAITING, STREAMING, ANSWERED, LEAVING, GONE }

    /** @param patience nanoseconds for which it may take no byte */
    CameraConnection(SocketChannel channel, String camera, DeviceProfile likeness, int door, int port, Demand demand, long patience) {
        this.channel = channel;
        this.camera = camera;
        this.profile = likeness;
        this.door = door;
        this.port = port;
        this.demand = demand;
        this.timeout = patience;
    }

    /** Where it is told what has come. */
    void setKey(SelectionKey selected) {
        key = selected;
    }

    /** Whatever it asks for, this is the answer. */
    void refuse(Request with) {
        refusal = with;
    }

    boolean isStreaming() {
        return stage == Stage.STREAMING;
    }

    boolean isGone() {
        return stage == Stage.GONE;
    }

    /** Bytes have come, or there is room for more. */
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

    /** It says nothing more: gone, unless it waits for an answer. */
    private void ended() {
        if (stage == Stage.WAITING || stage == Stage.ANSWERED) {
            key.interestOps(key.interestOps() & ~SelectionKey.OP_READ);
        } else {
            close();
        }
    }

    /** Where the head's empty line ends, 0 if it has not come. */
    private int end(int from, int to) {
        for (int i = from; i < to; i++) {
            if (head[i] == '\n' && (i > 0 && head[i - 1] == '\n' || i > 2 && head[i - 1] == '\r' && head[i - 2] == '\n')) {
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
     * Sends what there is for it, and loses patience.
     *
     * @param now the computer's clock, nanoseconds
     * @param stream the newest picture of the stream
     * @param still the last answer to those who wait for a still
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

    /** How long it may stay as it is. */
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

    /** Ends it. */
    void close() {
        stage = Stage.GONE;
        sending = null;
        try {
            channel.close();
        } catch (IOException e) {
            PictureServer.LOG.debug("closing a connection of {} failed: {}", camera, e.toString());
        }
    }

    /** A picture with its number. Immutable. */
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
