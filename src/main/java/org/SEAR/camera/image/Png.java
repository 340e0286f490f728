package org.SEAR.camera.image;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/** Pictures as PNG files (W3C, "Portable Network Graphics", 2003), of 8 bits a channel or of 16 bits of grey; made quickly rather than small. */
public final class Png {
    private static final byte[] MARK = {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10};
    private static final byte RGB = 2;
    private static final byte GREY = 0;
    /** Each byte less that of the same channel of the pixel to the left. */
    private static final byte LEFT = 1;
    private static final int MOST_GREY = 0xffff;

    private Png() {
    }

    /** @param pixels 0xRRGGBB each, row by row from the top left */
    public static byte[] ofColors(int width, int[] pixels) {
        int row = 1 + 3 * width;
        byte[] raw = new byte[pixels.length / width * row];
        int at = 0;
        for (int i = 0; i < pixels.length; i++) {
            boolean first = i % width == 0;
            if (first) {
                raw[at++] = LEFT;
            }
            int before = first ? 0 : pixels[i - 1];
            raw[at++] = (byte) ((pixels[i] >> 16) - (before >> 16));
            raw[at++] = (byte) ((pixels[i] >> 8) - (before >> 8));
            raw[at++] = (byte) (pixels[i] - before);
        }
        return file(width, pixels.length / width, 8, RGB, raw);
    }

    /** @param values 0 to 65535 each, row by row from the top left; lower ones become 0, higher ones 65535 */
    public static byte[] ofGrey(int width, int[] values) {
        int row = 1 + 2 * width;
        byte[] raw = new byte[values.length / width * row];
        int at = 0;
        int before = 0;
        for (int i = 0; i < values.length; i++) {
            if (i % width == 0) {
                raw[at++] = LEFT;
                before = 0;
            }
            int value = Math.max(0, Math.min(MOST_GREY, values[i]));
            raw[at++] = (byte) ((value >> 8) - (before >> 8));
            raw[at++] = (byte) (value - before);
            before = value;
        }
        return file(width, values.length / width, 16, GREY, raw);
    }

    private static byte[] file(int width, int height, int bits, byte kind, byte[] raw) {
        ByteArrayOutputStream out = new ByteArrayOutputStream(raw.length / 2 + 128);
        out.write(MARK, 0, MARK.length);
        ByteBuffer header = ByteBuffer.allocate(13).putInt(width).putInt(height).put((byte) bits).put(kind);
        chunk(out, "IHDR", header.array(), 13);
        Deflater deflater = new Deflater(Deflater.BEST_SPEED);
        deflater.setInput(raw);
        deflater.finish();
        byte[] packed = new byte[raw.length + raw.length / 1000 + 64];
        int length = 0;
        while (!deflater.finished()) {
            length += deflater.deflate(packed, length, packed.length - length);
        }
        deflater.end();
        chunk(out, "IDAT", packed, length);
        chunk(out, "IEND", packed, 0);
        return out.toByteArray();
    }

    private static void chunk(ByteArrayOutputStream out, String name, byte[] data, int length) {
        byte[] type = name.getBytes(StandardCharsets.US_ASCII);
        CRC32 check = new CRC32();
        check.update(type);
        check.update(data, 0, length);
        out.writeBytes(ByteBuffer.allocate(4).putInt(length).array());
        out.writeBytes(type);
        out.write(data, 0, length);
        out.writeBytes(ByteBuffer.allocate(4).putInt((int) check.getValue()).array());
    }
}
