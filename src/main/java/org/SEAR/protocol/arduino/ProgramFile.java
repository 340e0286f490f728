// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.arduino;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;

/**
 * A compiled program: Intel HEX (records 00 data, 01 end, 02 and 04 upper address, 03 and 05 start address) or ELF for
 * AVR (EM_AVR = 83, program headers of type PT_LOAD below the data space at 0x800000). Any thread.
 */
public final class ProgramFile {
    private static final int MACHINE_AVR = 83;
    private static final int DATA_SPACE = 0x800000;
    private static final int ELF_HEADER = 52;
    private static final int PROGRAM_HEADER = 32;
    private static final int RECORD_BYTES = 5;

    private ProgramFile() {
    }

    /** Returns whether a file has the name of a compiled program: .hex or .elf, in any case. */
    public static boolean isNamed(String file) {
        String plain = file.toLowerCase(Locale.ROOT);
        return plain.endsWith(".hex") || plain.endsWith(".elf");
    }

    /**
     * Returns the bytes of the flash from address 0.
     *
     * @param capacity size of the flash, bytes
     * @throws IllegalArgumentException with the line or the header, the problem and the legal values
     */
    public static byte[] read(byte[] file, int capacity) {
        boolean elf = file.length >= 4 && file[0] == 0x7F && file[1] == 'E' && file[2] == 'L' && file[3] == 'F';
        return elf ? readElf(file, capacity) : readHex(file, capacity);
    }

    private static byte[] readHex(byte[] file, int capacity) {
        byte[] flash = new byte[capacity];
        boolean[] used = new boolean[capacity];
        Arrays.fill(flash, (byte) 0xFF);
        int size = 0;
        int upper = 0;
        boolean ended = false;
        String[] lines = new String(file, StandardCharsets.ISO_8859_1).split("\r\n|\n|\r");
        for (int i = 0; i < lines.length; i++) {
            String line = lines[i].trim();
            if (line.isEmpty()) {
                continue;
            }
            check(!ended, i, "follows the end record; legal: nothing");
            int[] record = record(line, i);
            int length = record[0];
            int address = upper + (record[1] << 8) + record[2];
            switch (record[3]) {
                case 0:
                    check(address + length <= capacity, i, String.format(Locale.ROOT,
                        "writes up to address 0x%X; legal: below 0x%X, the end of the flash", address + length,
                        capacity));
                    for (int k = 0; k < length; k++) {
                        check(!used[address + k], i, String.format(Locale.ROOT,
                            "writes address 0x%X again; legal: once", address + k));
                        used[address + k] = true;
                        flash[address + k] = (byte) record[4 + k];
                    }
                    size = Math.max(size, address + length);
                    break;
                case 1:
                    check(length == 0, i, "is an end record with data; legal: none");
                    ended = true;
                    break;
                case 2:
                case 4:
                    check(length == 2, i, "has " + length + " bytes of upper address; legal: 2");
                    upper = ((record[4] << 8) + record[5]) << (record[3] == 2 ? 4 : 16);
                    check(upper >= 0 && upper < 1 << 24, i, "has an upper address beyond 16 MiB; legal: below");
                    break;
                case 3:
                case 5:
                    check(length == 4, i, "has " + length + " bytes of start address; legal: 4");
                    break;
                default:
                    check(false, i, "has record type " + record[3] + "; legal: 0 to 5");
                    break;
            }
        }
        check(ended, lines.length - 1, "is the last, but no end record :00000001FF; is the file cut off?");
        check(size > 0, lines.length - 1, "ends a file without data; legal: a program");
        return Arrays.copyOf(flash, size);
    }

    /** Reads length, address, type and data of a line, and checks the sum. */
    private static int[] record(String line, int number) {
        check(line.charAt(0) == ':', number, "begins with " + shown(line.charAt(0)) + "; legal: a colon (Intel HEX)");
        check(line.length() % 2 != 0 && line.length() > 2 * RECORD_BYTES, number,
            "has " + line.length() + " characters; legal: 11, 13, 15 and so on");
        int[] bytes = new int[line.length() / 2];
        int sum = 0;
        for (int i = 0; i < bytes.length; i++) {
            int high = Character.digit(line.charAt(1 + 2 * i), 16);
            int low = Character.digit(line.charAt(2 + 2 * i), 16);
            check(high >= 0 && low >= 0, number, "has "
                + shown(line.charAt(high < 0 ? 1 + 2 * i : 2 + 2 * i)) + "; legal: hexadecimal digits");
            bytes[i] = high << 4 | low;
            sum += bytes[i];
        }
        check(bytes.length == bytes[0] + RECORD_BYTES, number, "has " + (bytes.length - RECORD_BYTES)
            + " bytes of data but states " + bytes[0] + "; legal: as many as stated");
        check((sum & 0xFF) == 0, number, String.format(Locale.ROOT, "has the checksum %02X; legal: %02X",
            bytes[bytes.length - 1], bytes[bytes.length - 1] - sum & 0xFF));
        return bytes;
    }

    private static String shown(char c) {
        return c > ' ' && c < 127 ? "'" + c + "'" : String.format(Locale.ROOT, "the character 0x%02X", (int) c);
    }

    private static void check(boolean good, int line, String problem) {
        if (!good) {
            throw new IllegalArgumentException("line " + (line + 1) + " " + problem);
        }
    }

    private static byte[] readElf(byte[] file, int capacity) {
        ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        checkElf(file.length >= ELF_HEADER && file[4] == 1 && file[5] == 1, "the header", "is not that of a 32-bit "
            + "little-endian ELF file");
        checkElf(in.getShort(18) == MACHINE_AVR, "the machine", "is " + in.getShort(18) + "; legal: 83 (AVR)");
        long table = in.getInt(28) & 0xFFFFFFFFL;
        int entry = in.getShort(42) & 0xFFFF;
        int entries = in.getShort(44) & 0xFFFF;
        checkElf(entry == PROGRAM_HEADER && table + (long) entry * entries <= file.length, "the program header table",
            "lies outside the file");
        byte[] flash = new byte[capacity];
        Arrays.fill(flash, (byte) 0xFF);
        int size = 0;
        for (int i = 0; i < entries; i++) {
            int at = (int) table + i * entry;
            long offset = in.getInt(at + 4) & 0xFFFFFFFFL;
            long address = in.getInt(at + 12) & 0xFFFFFFFFL;
            long length = in.getInt(at + 16) & 0xFFFFFFFFL;
            if (in.getInt(at) != 1 || length == 0 || address >= DATA_SPACE) {
                continue;
            }
            checkElf(offset + length <= file.length, "segment " + i, "lies outside the file");
            checkElf(address + length <= capacity, "segment " + i, String.format(Locale.ROOT,
                "writes up to address 0x%X; legal: below 0x%X, the end of the flash", address + length, capacity));
            System.arraycopy(file, (int) offset, flash, (int) address, (int) length);
            size = Math.max(size, (int) (address + length));
        }
        checkElf(size > 0, "the file", "has no program for the flash");
        return Arrays.copyOf(flash, size);
    }

    private static void checkElf(boolean good, String part, String problem) {
        if (!good) {
            throw new IllegalArgumentException(part + " " + problem);
        }
    }
}
