// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/** Writes zip files byte by byte, with any false field that a test needs. */
final class RawZip {
    /** One entry. Its fields are those of the zip file and true unless a test changes them. */
    static final class Entry {
        byte[] name;
        byte[] localName;
        byte[] data;
        byte[] extra = new byte[0];
        int method;
        int flags = 0x0800;
        int crc;
        long size;
        long packed;
        int unixMode;
        int madeBy = 3;
        long offset = -1;

        Entry unix(int mode) {
            unixMode = mode;
            return this;
        }

        /** @param value 3 for Unix, 0 for MS-DOS and Windows */
        Entry madeBy(int value) {
            madeBy = value;
            return this;
        }

        Entry flags(int value) {
            flags = value;
            return this;
        }

        Entry method(int value) {
            method = value;
            return this;
        }

        Entry size(long value) {
            size = value;
            return this;
        }

        Entry crc(int value) {
            crc = value;
            return this;
        }

        Entry offset(long value) {
            offset = value;
            return this;
        }

        Entry extra(byte[] value) {
            extra = value;
            return this;
        }

        Entry localName(String value) {
            localName = value.getBytes(StandardCharsets.UTF_8);
            return this;
        }
    }

    private final List<Entry> entries = new ArrayList<>();

    /** Makes a bundle with its version entry. */
    static RawZip bundle() {
        RawZip zip = new RawZip();
        zip.stored("sear-version.txt", "1\n");
        return zip;
    }

    Entry stored(String name, String text) {
        return stored(name.getBytes(StandardCharsets.UTF_8), text.getBytes(StandardCharsets.ISO_8859_1));
    }

    Entry stored(byte[] name, byte[] data) {
        Entry entry = new Entry();
        entry.name = name;
        entry.localName = name;
        entry.data = data;
        CRC32 crc = new CRC32();
        crc.update(data);
        entry.crc = (int) crc.getValue();
        entry.size = data.length;
        entry.packed = data.length;
        entries.add(entry);
        return entry;
    }

    Entry deflated(String name, byte[] plain) {
        Entry entry = stored(name.getBytes(StandardCharsets.UTF_8), plain);
        Deflater deflater = new Deflater(9, true);
        deflater.setInput(plain);
        deflater.finish();
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        byte[] block = new byte[65536];
        while (!deflater.finished()) {
            packed.write(block, 0, deflater.deflate(block));
        }
        deflater.end();
        entry.data = packed.toByteArray();
        entry.packed = entry.data.length;
        entry.method = ZipDirectory.DEFLATED;
        return entry;
    }

    byte[] bytes() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream directory = new ByteArrayOutputStream();
        for (Entry entry : entries) {
            long offset = entry.offset >= 0 ? entry.offset : out.size();
            ByteBuffer local = buffer(30).putInt(0x04034b50).putShort((short) 20);
            common(local, entry).putShort((short) entry.localName.length).putShort((short) 0);
            out.writeBytes(local.array());
            out.writeBytes(entry.localName);
            out.writeBytes(entry.data);
            ByteBuffer central = buffer(46).putInt(0x02014b50).putShort((short) (entry.madeBy << 8 | 20))
                .putShort((short) 20);
            common(central, entry).putShort((short) entry.name.length).putShort((short) entry.extra.length);
            central.putShort((short) 0).putShort((short) 0).putShort((short) 0).putShort((short) 0)
                .putShort((short) entry.unixMode);
            central.putInt((int) offset);
            directory.writeBytes(central.array());
            directory.writeBytes(entry.name);
            directory.writeBytes(entry.extra);
        }
        ByteBuffer end = buffer(22).putInt(0x06054b50).putInt(0).putShort((short) entries.size())
            .putShort((short) entries.size());
        end.putInt(directory.size()).putInt(out.size()).putShort((short) 0);
        out.writeBytes(directory.toByteArray());
        out.writeBytes(end.array());
        return out.toByteArray();
    }

    private static ByteBuffer common(ByteBuffer out, Entry entry) {
        return out.putShort((short) entry.flags).putShort((short) entry.method).putInt(0x00210000).putInt(entry.crc)
            .putInt((int) entry.packed).putInt((int) entry.size);
    }

    private static ByteBuffer buffer(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }
}
