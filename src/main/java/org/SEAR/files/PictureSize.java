// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads the decoded size of a picture from its header. Any thread. */
public final class PictureSize {
    private static final int PNG_HEAD = 8;
    private static final int PNG_AROUND = 12;
    /** Parts of a PNG that affect its pixels; others are texts and colour profiles, which may be compressed, too. */
    private static final Set<String> PNG_PARTS = Set.of("IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "sRGB");
    private static final Pattern HDR_SIZE = Pattern.compile("[-+]Y (\\d{1,9}) [-+]X (\\d{1,9})");
    private static final int HDR_HEAD = 4096;
    private static final int DDS_HEAD = 128;
    private static final int TGA_HEAD = 18;
    /** Limit of a .dds: all mip maps, cube sides and slices together, in pictures of its size. */
    private static final int MAX_DDS_PARTS = 8;

    private PictureSize() {
    }

    /**
     * Checks that a picture is safe to decode.
     *
     * @param name its file, whose ending tells the format
     * @return the picture without data that its pixels don't need
     * @throws IOException with the file, its size and the limit
     */
    public static byte[] checked(byte[] bytes, String name) throws IOException {
        of(bytes, name);
        return isPng(bytes) ? pixelsOf(bytes) : bytes;
    }

    /**
     * Returns the width and height of a picture, pixels.
     *
     * @param name its file, whose ending tells the format
     * @throws IOException if it is not safe to decode, with the file, its size and the limit
     */
    public static int[] of(byte[] bytes, String name) throws IOException {
        FileLimits.range(name, "the file's size", bytes.length, 1, FileLimits.MAX_PICTURE);
        ByteBuffer head = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        String lower = name.toLowerCase(Locale.ROOT);
        if (lower.endsWith(".tga")) {
            need(name, bytes, TGA_HEAD);
            return checked(name, Short.toUnsignedInt(head.getShort(12)), Short.toUnsignedInt(head.getShort(14)));
        } else if (lower.endsWith(".dds")) {
            need(name, bytes, DDS_HEAD);
            FileLimits.range(name, "the depth", head.getInt(24), 0, MAX_DDS_PARTS);
            FileLimits.range(name, "the number of mip maps", head.getInt(28), 0, 16);
            return checked(name, Integer.toUnsignedLong(head.getInt(16)), Integer.toUnsignedLong(head.getInt(12)));
        } else if (lower.endsWith(".hdr")) {
            Matcher size = HDR_SIZE.matcher(
                new String(bytes, 0, Math.min(bytes.length, HDR_HEAD), StandardCharsets.ISO_8859_1));
            if (!size.find()) {
                throw FileLimits.wrong(name, "the picture", "without a size", "a .hdr with -Y HEIGHT +X WIDTH");
            }
            return checked(name, Long.parseLong(size.group(2)), Long.parseLong(size.group(1)));
        }
        int[] size = readByJava(bytes, name);
        WholePicture.require(bytes, name);
        return size;
    }

    private static void need(String name, byte[] bytes, int head) throws IOException {
        FileLimits.range(name, "the file's size", bytes.length, head, FileLimits.MAX_PICTURE);
    }

    private static int[] readByJava(byte[] bytes, String name) throws IOException {
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) {
                throw new UnreadablePicture(name + ": the picture is in no known format, legal: PNG, JPEG, GIF, BMP, "
                    + "TGA, DDS or HDR", null);
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(in, true, true);
                int[] size = size(reader, name);
                return checked(name, size[0], size[1]);
            } finally {
                reader.dispose();
            }
        }
    }

    private static int[] size(ImageReader reader, String name) throws IOException {
        try {
            return new int[] {reader.getWidth(0), reader.getHeight(0)};
        } catch (RuntimeException | IOException e) {
            throw new UnreadablePicture(name + ": the picture is broken (" + e.getMessage()
                + "), legal: a whole picture", e);
        }
    }

    private static int[] checked(String name, long width, long height) throws IOException {
        if (width < 1 || height < 1 || width * height > FileLimits.MAX_PIXELS) {
            throw FileLimits.wrong(name, "the picture's size", width + " x " + height, "at most "
                + FileLimits.MAX_PIXELS + " pixels");
        }
        return new int[] {(int) width, (int) height};
    }

    private static boolean isPng(byte[] bytes) {
        return bytes.length > PNG_HEAD && ByteBuffer.wrap(bytes).getInt() == 0x89504e47;
    }

    private static byte[] pixelsOf(byte[] bytes) {
        ByteArrayOutputStream out = new ByteArrayOutputStream(bytes.length);
        out.write(bytes, 0, PNG_HEAD);
        ByteBuffer in = ByteBuffer.wrap(bytes);
        int at = PNG_HEAD;
        while (at + PNG_AROUND <= bytes.length) {
            long length = Integer.toUnsignedLong(in.getInt(at)) + PNG_AROUND;
            int size = (int) Math.min(length, bytes.length - at);
            if (PNG_PARTS.contains(new String(bytes, at + 4, 4, StandardCharsets.ISO_8859_1))) {
                out.write(bytes, at, size);
            }
            at += size;
        }
        return out.toByteArray();
    }
}
