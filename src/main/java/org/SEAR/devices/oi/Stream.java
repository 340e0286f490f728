// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import java.io.ByteArrayOutputStream;

/** Stream of packets that a robot sends every 15 ms (command 148), {@code 13 | size | id data ... | checksum}. */
final class Stream {
    private static final int HEADER = 19;

    private final boolean headerSummed;
    private int[] ids = new int[0];
    private boolean running;

    /** @param headerSummed true: all bytes of a frame sum to 0 modulo 256; false: all bytes except the header */
    Stream(boolean headerSummed) {
        this.headerSummed = headerSummed;
    }

    void start(int[] packets) {
        ids = packets;
        running = packets.length > 0;
    }

    void pause() {
        running = false;
    }

    void resume() {
        running = ids.length > 0;
    }

    boolean isRunning() {
        return running;
    }

    /** Number of packets (packet 38). */
    int getLength() {
        return ids.length;
    }

    /** Size of a frame with these packets, bytes. */
    static int frameSize(int[] packets) {
        int size = 3;
        for (int id : packets) {
            size += 1 + Packet.size(id);
        }
        return size;
    }

    int frameSize() {
        return frameSize(ids);
    }

    byte[] frame(SensorPackets packets, double time) {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        for (int id : ids) {
            data.write(id);
            packets.write(id, data, time);
        }
        return frame(data.toByteArray(), headerSummed);
    }

    /** Adds header, size and checksum to data. */
    static byte[] frame(byte[] data, boolean headerSummed) {
        byte[] frame = new byte[data.length + 3];
        frame[0] = HEADER;
        frame[1] = (byte) data.length;
        System.arraycopy(data, 0, frame, 2, data.length);
        int sum = headerSummed ? 0 : -HEADER;
        for (byte value : frame) {
            sum += value;
        }
        frame[frame.length - 1] = (byte) -sum;
        return frame;
    }
}
