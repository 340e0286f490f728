// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.SEAR.files.FileLimits;

/**
 * Checks the blocks of a Blender file, and its description of structures, before jMonkeyEngine's loader follows them.
 * The file contains a head, blocks with code, size, former address, structure and count, and the description in the
 * block DNA1.
 */
final class BlendCheck {
    private static final String HEAD = "BLENDER";
    private static final int HEAD_BYTES = 12;
    private static final String WHOLE = "a whole, unpacked or gzipped file of Blender 2.49 to 2.79; or export .glb";

    private final String file;
    private final ByteBuffer in;
    private String what = "the head";
    private int pointer;
    /** Bytes of each structure; null before the description. */
    private int[] structures;

    BlendCheck(String file, byte[] bytes) {
        this.file = file;
        this.in = ByteBuffer.wrap(bytes);
    }

    /** @throws IOException that names the block, the value and the legal values */
    void check() throws IOException {
        try {
            head();
            int start = in.position();
            blocks();
            if (structures == null) {
                throw FileLimits.wrong(file, "the description of the structures (block DNA1)", "missing", WHOLE);
            }
            in.limit(in.capacity()).position(start);
            blocks();
        } catch (BufferUnderflowException e) {
            throw cutOff();
        }
    }

    private IOException cutOff() {
        return FileLimits.wrong(file, what + " before byte " + in.position(), "cut off", WHOLE);
    }

    private void head() throws IOException {
        String head = text(Math.min(HEAD_BYTES, in.remaining()));
        if (!head.matches("BLENDER[-_][vV]\\d{3}")) {
            throw FileLimits.wrong(file, "the head", head, HEAD + "-v and three digits: " + WHOLE);
        }
        pointer = head.charAt(HEAD.length()) == '-' ? Long.BYTES : Integer.BYTES;
        in.order(head.charAt(HEAD.length() + 1) == 'v' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    }

    private String text(int length) {
        byte[] bytes = new byte[length];
        in.get(bytes);
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    private void align() {
        in.position(Math.min(in.limit(), (in.position() + 3) / 4 * 4));
    }

    private void blocks() throws IOException {
        boolean known = structures != null;
        for (int i = 0;; i++) {
            align();
            what = "the head of block " + i;
            int at = in.position();
            String code = text(4);
            what = "block " + i + " (" + code.trim() + ") at byte " + at;
            int size = in.getInt();
            in.position(Math.min(in.limit(), in.position() + pointer));
            int structure = in.getInt();
            int count = in.getInt();
            if (code.equals("ENDB")) {
                return;
            }
            FileLimits.range(file, "the size of " + what, size, 0, in.remaining());
            int end = in.position() + size;
            if (code.equals("DNA1") && !known) {
                describe();
            } else if (known && !code.equals("DNA1")) {
                FileLimits.range(file, "the structure of " + what, structure, 0, structures.length - 1);
                FileLimits.range(file, "the number of structures of " + what, count, 0,
                    structure == 0 ? Integer.MAX_VALUE : size / Math.max(1, structures[structure]));
            }
            in.limit(in.capacity()).position(end);
        }
    }

    /** Reads names, types, lengths and structures. */
    private void describe() throws IOException {
        what = "the description of the structures";
        expect("SDNA");
        int names = words("NAME");
        int types = words("TYPE");
        expect("TLEN");
        int[] lengths = new int[types];
        for (int i = 0; i < types; i++) {
            lengths[i] = Short.toUnsignedInt(in.getShort());
        }
        align();
        expect("STRC");
        int count = in.getInt();
        FileLimits.range(file, "the number of structures", count, 1, in.remaining() / 4);
        structures = new int[count];
        for (int i = 0; i < count; i++) {
            structures[i] = lengths[index("the type of structure " + i, types)];
            int fields = in.getShort();
            FileLimits.range(file, "the number of fields of structure " + i, fields, 0, in.remaining() / 4);
            for (int f = 0; f < fields; f++) {
                index("the type of field " + f + " of structure " + i, types);
                index("the name of field " + f + " of structure " + i, names);
            }
        }
    }

    private void expect(String mark) throws IOException {
        String found = text(4);
        if (!found.equals(mark)) {
            throw FileLimits.wrong(file, "the mark in " + what + " at byte " + (in.position() - 4), found, mark);
        }
    }

    /** Skips a list of words; returns their number. */
    private int words(String mark) throws IOException {
        expect(mark);
        int count = in.getInt();
        FileLimits.range(file, "the number of words " + mark, count, 1, in.remaining());
        for (int i = 0; i < count; i++) {
            while (in.get() != 0) {
                what = "word " + i + " of " + mark;
            }
        }
        align();
        what = "the description of the structures";
        return count;
    }

    private int index(String of, int count) throws IOException {
        int index = in.getShort();
        FileLimits.range(file, of, index, 0, count - 1L);
        return index;
    }
}
