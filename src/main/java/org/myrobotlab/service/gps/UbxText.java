// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;

/** Converts UBX messages from and to text. */
public final class UbxText {
    private static final int HEX = 16;
    private static final int VERSION_SIZE = 30;

    private UbxText() {
    }

    /**
     * Returns a message.
     *
     * @param hex class, number and payload, for example {@code "06 01 01 07 01"}
     * @throws IllegalArgumentException unless the text has at least two hexadecimal bytes and at most those of a frame
     */
    public static UbxFrame frame(String hex) {
        String plain = hex == null ? "" : hex.replaceAll("\\s", "");
        int count = plain.length() / 2;
        if (!plain.matches("([0-9A-Fa-f]{2}){2,}") || count > UbxFrame.MOST) {
            throw new IllegalArgumentException(
                "UBX message is \"" + hex + "\", legal: class, number and payload as 2 to " + UbxFrame.MOST
                + " bytes in hexadecimal, for example \"06 01 01 07 01\"");
        }
        byte[] bytes = new byte[count];
        for (int i = 0; i < count; i++) {
            bytes[i] = (byte) Integer.parseInt(plain.substring(2 * i, 2 * i + 2), HEX);
        }
        return new UbxFrame(bytes[0] & 0xFF, bytes[1] & 0xFF, Arrays.copyOfRange(bytes, 2, count));
    }

    /** Returns the firmware version in MON-VER. */
    public static String version(UbxFrame frame) {
        byte[] payload = frame.getPayload();
        return new String(payload, 0, Math.min(VERSION_SIZE, payload.length), StandardCharsets.US_ASCII)
            .split("\0", 2)[0];
    }

    /** Returns the name of the message that an ACK-NAK rejects. */
    public static String refused(UbxFrame frame) {
        if (frame.getLength() < 2) {
            return "a message";
        }
        int group = frame.getPayload()[0] & 0xFF;
        int id = frame.getPayload()[1] & 0xFF;
        UbxMessage message = UbxMessage.of(group, id);
        return message == null ? String.format(Locale.ROOT, "message %02X %02X", group, id) : message.name()
            .replace('_', '-');
    }
}
