// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.SEAR.project.problems.ProblemList;

/**
 * Reader of the directory of an untrusted zip file. Both records of each entry have to agree. Entries must not overlap,
 * be links or be encrypted. The file has to start with the first entry and end with the directory. Numbers and layout:
 * PKWARE's APPNOTE 6.3, sections 4.3 and 4.4.
 */
final class ZipDirectory {
    static final int STORED = 0;
    static final int DEFLATED = 8;
    private static final int END_SIZE = 22;
    private static final int END_MARK = 0x06054b50;
    private static final int ENTRY_SIZE = 46;
    private static final int ENTRY_MARK = 0x02014b50;
    private static final int LOCAL_SIZE = 30;
    private static final int LOCAL_MARK = 0x04034b50;
    /** Flag bits: encrypted, strongly encrypted, masked header. */
    private static final int ENCRYPTED = 0x0001 | 0x0040 | 0x2000;
    private static final int UTF8 = 0x0800;
    /** Systems in the upper byte of "version made by": MS-DOS, which Windows programs write, and Windows NTFS. */
    private static final int DOS = 0;
    private static final int NTFS = 10;
    /** Code page of names without the UTF-8 flag (APPNOTE, appendix D). */
    private static final String DOS_LETTERS = "IBM437";
    private static final int UNIX_TYPE = 0xf000;
    private static final int UNIX_FILE = 0x8000;
    private static final int UNIX_FOLDER = 0x4000;
    private static final int ZIP64 = 0x0001;
    private static final int UNICODE_PATH = 0x7075;
    private static final int UNICODE_PATH_HEAD = 5;

    /** One entry of the zip file. */
    static final class Entry {
        String name;
        byte[] nameBytes;
        int madeBy;
        int flags;
        int method;
        long crc;
        long packed;
        long size;
        long offset;
        int unixMode;
        long dataStart;

        boolean isFolder() {
            return name.endsWith("/");
        }

        boolean isFromWindows() {
            return madeBy == DOS || madeBy == NTFS;
        }

        /** Returns whether the name has characters other than ASCII but no UTF-8 flag. */
        boolean isNameUnmarked() {
            return (flags & UTF8) == 0 && name.chars().anyMatch(c -> c > 0x7f);
        }
    }

    private final FileChannel channel;
    private final String file;
    private final ProblemList problems;

    ZipDirectory(FileChannel channel, String file, ProblemList problems) {
        this.channel = channel;
        this.file = file;
        this.problems = problems;
    }

    /** Returns the entries in the directory's order; adds problems if the directory is invalid. */
    List<Entry> read() throws IOException {
        List<Entry> entries = new ArrayList<>();
        long length = channel.size();
        ByteBuffer end = length < END_SIZE ? ByteBuffer.allocate(0) : bytes(length - END_SIZE, END_SIZE);
        if (length < END_SIZE || end.getInt(0) != END_MARK || end.getShort(20) != 0) {
            refuse("it is no zip file, or cut off", "a whole zip file without comment");
            return entries;
        }
        int count = unsigned(end.getShort(10));
        long directorySize = unsigned(end.getInt(12));
        long directoryStart = unsigned(end.getInt(16));
        if (end.getInt(4) != 0 || unsigned(end.getShort(8)) != count || directoryStart + directorySize != length
            - END_SIZE) {
            refuse("its directory is not where it should be", "a zip file in one piece, below 4 GiB");
            return entries;
        }
        if (count > BundleRules.MAX_ENTRIES || directorySize > BundleRules.MAX_ENTRIES * 1024L) {
            refuse("it has " + count + " entries", "at most " + BundleRules.MAX_ENTRIES);
            return entries;
        }
        ByteBuffer directory = bytes(directoryStart, (int) directorySize);
        for (int i = 0; i < count; i++) {
            Entry entry = entry(directory);
            if (entry == null) {
                refuse("its directory is broken at entry " + i, "a whole zip file");
                return entries;
            }
            entries.add(entry);
        }
        if (directory.hasRemaining()) {
            refuse("its directory has additional data", "a whole zip file");
        }
        if (problems.isEmpty()) {
            checkLayout(entries, directoryStart);
        }
        return entries;
    }

    private Entry entry(ByteBuffer in) {
        if (in.remaining() < ENTRY_SIZE || in.getInt(in.position()) != ENTRY_MARK) {
            return null;
        }
        int at = in.position();
        Entry entry = new Entry();
        entry.madeBy = unsigned(in.getShort(at + 4)) >> 8;
        entry.flags = unsigned(in.getShort(at + 8));
        entry.method = unsigned(in.getShort(at + 10));
        entry.crc = unsigned(in.getInt(at + 16));
        entry.packed = unsigned(in.getInt(at + 20));
        entry.size = unsigned(in.getInt(at + 24));
        int nameLength = unsigned(in.getShort(at + 28));
        int extraLength = unsigned(in.getShort(at + 30));
        int commentLength = unsigned(in.getShort(at + 32));
        entry.unixMode = unsigned(in.getShort(at + 40));
        entry.offset = unsigned(in.getInt(at + 42));
        if (in.remaining() < ENTRY_SIZE + nameLength + extraLength + commentLength) {
            return null;
        }
        in.position(at + ENTRY_SIZE);
        byte[] name = new byte[nameLength];
        in.get(name);
        entry.nameBytes = name;
        entry.name = decode(entry);
        checkExtra(entry, in, extraLength);
        in.position(in.position() + extraLength + commentLength);
        check(entry);
        return entry;
    }

    /** Decodes a name: macOS writes UTF-8 without the flag, and Windows uses the MS-DOS code page. */
    private String decode(Entry entry) {
        byte[] name = entry.nameBytes;
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(name)).toString();
        } catch (CharacterCodingException e) {
            if ((entry.flags & UTF8) == 0 && entry.isFromWindows() && Charset.isSupported(DOS_LETTERS)) {
                return new String(name, Charset.forName(DOS_LETTERS));
            }
            refuse("a name is not UTF-8 (" + e + ")", "names in UTF-8");
            return new String(name, StandardCharsets.ISO_8859_1);
        }
    }

    private void checkExtra(Entry entry, ByteBuffer in, int length) {
        int at = in.position();
        int end = at + length;
        while (at + 4 <= end) {
            int kind = unsigned(in.getShort(at));
            if (kind == ZIP64) {
                refuse(entry, "below 4 GiB, without zip64 records");
            } else if (kind == UNICODE_PATH && !isSameName(entry, in, at + 4, unsigned(in.getShort(at + 2)))) {
                refuse(entry, "one name, without a second one in an extra record");
            }
            at += 4 + unsigned(in.getShort(at + 2));
        }
    }

    /**
     * Returns whether a UTF-8 name record, which some programs add, repeats the name: version, CRC and the name's
     * bytes.
     */
    private static boolean isSameName(Entry entry, ByteBuffer in, int at, int length) {
        if (length != UNICODE_PATH_HEAD + entry.nameBytes.length || at + length > in.limit()) {
            return false;
        }
        byte[] name = new byte[entry.nameBytes.length];
        in.duplicate().position(at + UNICODE_PATH_HEAD).get(name);
        return Arrays.equals(name, entry.nameBytes);
    }

    private void check(Entry entry) {
        int type = entry.unixMode & UNIX_TYPE;
        if (type != 0 && type != UNIX_FILE && type != UNIX_FOLDER) {
            refuse(entry, "an ordinary file, neither a link nor a device");
        }
        if ((entry.flags & ENCRYPTED) != 0) {
            refuse(entry, "not encrypted");
        }
        if (entry.method != STORED && entry.method != DEFLATED) {
            refuse(entry, "stored or deflated; this has method " + entry.method);
        }
        if (entry.method == STORED && entry.packed != entry.size) {
            refuse(entry, "one size; this says " + entry.packed + " and " + entry.size + " bytes");
        }
        if (entry.isFolder() && entry.size != 0) {
            refuse(entry, "a folder without content");
        }
        if (entry.size > BundleRules.RATIO_FREE && entry.size / Math.max(1, entry.packed) > BundleRules.MAX_RATIO) {
            refuse(entry, "compressed at most " + BundleRules.MAX_RATIO + " times; this unpacks " + entry.packed
                + " to " + entry.size + " bytes");
        }
    }

    private void checkLayout(List<Entry> entries, long directoryStart) throws IOException {
        List<Entry> inOrder = new ArrayList<>(entries);
        inOrder.sort(Comparator.comparingLong(e -> e.offset));
        long free = 0;
        for (Entry entry : inOrder) {
            if (entry.offset < free || entry.offset + LOCAL_SIZE > directoryStart || free == 0 && entry.offset != 0) {
                refuse(entry, "a place of its own in the file");
                return;
            }
            ByteBuffer local = bytes(entry.offset, LOCAL_SIZE);
            int nameLength = unsigned(local.getShort(26));
            entry.dataStart = entry.offset + LOCAL_SIZE + nameLength + unsigned(local.getShort(28));
            free = entry.dataStart + entry.packed;
            if (local.getInt(0) != LOCAL_MARK || unsigned(local.getShort(8)) != entry.method || free > directoryStart
                || !Arrays.equals(localName(entry, nameLength, directoryStart), entry.nameBytes)) {
                refuse(entry, "the same in the directory and at its place");
                return;
            }
        }
    }

    private byte[] localName(Entry entry, int length, long directoryStart) throws IOException {
        long start = entry.offset + LOCAL_SIZE;
        return start + length > directoryStart ? new byte[0] : bytes(start, length).array();
    }

    private ByteBuffer bytes(long position, int length) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        while (buffer.hasRemaining() && channel.read(buffer, position + buffer.position()) >= 0) {
            continue;
        }
        buffer.flip();
        if (buffer.limit() < length) {
            throw new IOException(file + " became shorter while it was read");
        }
        return buffer;
    }

    private void refuse(String what, String legal) {
        problems.add(file, 0, "", what, legal);
    }

    private void refuse(Entry entry, String legal) {
        problems.add(file, 0, "entry", entry.name, legal);
    }

    private static int unsigned(short value) {
        return Short.toUnsignedInt(value);
    }

    private static long unsigned(int value) {
        return Integer.toUnsignedLong(value);
    }
}
