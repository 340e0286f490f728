// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import java.util.Locale;

/** Conversion between bytes and hexadecimal text. */
public final class Bytes {
    private Bytes() {
    }

    public static int[] ints(String hex) {
        String plain = hex.replaceAll("\\s", "");
        int[] out = new int[plain.length() / 2];
        for (int i = 0; i < out.length; i++) {
            out[i] = Integer.parseInt(plain.substring(2 * i, 2 * i + 2), 16);
        }
        return out;
    }

    public static byte[] bytes(String hex) {
        int[] values = ints(hex);
        byte[] out = new byte[values.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = (byte) values[i];
        }
        return out;
    }

    public static String hex(byte[] bytes) {
        StringBuilder out = new StringBuilder();
        for (byte value : bytes) {
            out.append(out.length() == 0 ? "" : " ").append(String.format(Locale.ROOT, "%02X", value & 0xFF));
        }
        return out.toString();
    }
}
