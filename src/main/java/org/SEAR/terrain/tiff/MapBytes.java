// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.tiff;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;

/**
 * Bytes of a map file. Reads only requested parts, so a large file takes no more memory than the parts in use. One
 * thread at a time.
 */
public final class MapBytes implements Closeable {
    /** Maximum size of a map file, bytes. */
    public static final long MAX_FILE = 4L << 30;
    /** Maximum size of a bundled or unpacked map, which is in memory as a whole, bytes. */
    public static final int MAX_UNPACKED = 64 << 20;

    private final String name;
    private final FileChannel channel;
    private final byte[] bytes;
    private final long size;

    private MapBytes(String name, FileChannel channel, byte[] bytes, long size) throws IOException {
        this.name = name;
        this.channel = channel;
        this.bytes = bytes;
        this.size = size;
        FileLimits.range(name, "the file's size", size, 1, MAX_FILE);
    }

    /**
     * Opens an asset.
     * @param path as written in an object
     * @throws IOException if the asset is missing, empty or too large
     */
    public static MapBytes open(Assets assets, String path) throws IOException {
        Path file = assets.getFolder().resolve(path);
        if (!Files.isRegularFile(file)) {
            try (InputStream in = assets.open(path)) {
                byte[] all = in.readNBytes(MAX_UNPACKED + 1);
                FileLimits.range(path, "the file's size", all.length, 1, MAX_UNPACKED);
                return of(path, all);
            }
        }
        FileChannel channel = FileChannel.open(file, StandardOpenOption.READ);
        try {
            return new MapBytes(path, channel, null, channel.size());
        } catch (IOException e) {
            channel.close();
            throw e;
        }
    }

    /**
     * Wraps bytes in memory.
     * @param name their name in messages
     * @throws IOException if the array is empty
     */
    public static MapBytes of(String name, byte[] bytes) throws IOException {
        return new MapBytes(name, null, bytes, bytes.length);
    }

    /** Returns the file's name in messages. */
    public String getName() {
        return name;
    }

    /** Returns the size, bytes. */
    public long size() {
        return size;
    }

    /**
     * Reads a part.
     * @param what the part's name in messages
     * @throws IOException if the file ends before the part does
     */
    public byte[] read(String what, long position, int length) throws IOException {
        requirePart(what, position, length);
        byte[] part = new byte[length];
        read(what, position, part, length);
        return part;
    }

    /**
     * Reads a part into an array, from index 0.
     * @param what the part's name in messages
     * @throws IOException if the file ends before the part does
     */
    public void read(String what, long position, byte[] into, int length) throws IOException {
        requirePart(what, position, length);
        if (bytes != null) {
            System.arraycopy(bytes, (int) position, into, 0, length);
            return;
        }
        ByteBuffer buffer = ByteBuffer.wrap(into, 0, length);
        while (buffer.hasRemaining()) {
            if (channel.read(buffer, position + buffer.position()) < 0) {
                throw new IOException(name + ": the file shrank while SEAR read it");
            }
        }
    }

    /**
     * Throws if a part is not inside the file.
     * @param what the part's name in messages
     * @throws IOException that names the part
     */
    public void requirePart(String what, long position, long length) throws IOException {
        if (position < 0 || length < 0 || position > size || length > size - position) {
            throw FileLimits.wrong(name, what, length + " bytes at " + position, "inside the file, which has " + size
                + " bytes (is it cut off?)");
        }
    }

    @Override
    public void close() throws IOException {
        if (channel != null) {
            channel.close();
        }
    }
}
