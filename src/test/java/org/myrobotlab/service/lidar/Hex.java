package org.myrobotlab.service.lidar;

/** Bytes as telegram listings print them. */
final class Hex {
    private static final int BASE = 16;

    private Hex() {
    }

    /** {@code "02 80 03"} as bytes. */
    static byte[] bytes(String text) {
        String[] parts = text.trim().split("\\s+");
        byte[] bytes = new byte[parts.length];
        for (int i = 0; i < parts.length; i++) {
            bytes[i] = (byte) Integer.parseInt(parts[i], BASE);
        }
        return bytes;
    }

    /** Bytes as {@code "02 80 03"}. */
    static String text(byte[] bytes) {
        StringBuilder text = new StringBuilder();
        for (byte b : bytes) {
            text.append(text.length() == 0 ? "" : " ").append(String.format("%02X", b));
        }
        return text.toString();
    }

    /** Two arrays, one after the other. */
    static byte[] join(byte[]... parts) {
        java.io.ByteArrayOutputStream joined = new java.io.ByteArrayOutputStream();
        for (byte[] part : parts) {
            joined.write(part, 0, part.length);
        }
        return joined.toByteArray();
    }
}
