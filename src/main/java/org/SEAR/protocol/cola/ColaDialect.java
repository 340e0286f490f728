// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.cola;

import java.io.ByteArrayOutputStream;

/**
 * The two forms of a telegram. A: {@code 02 text 03}. B: {@code 02 02 02 02}, four bytes payload length with the high
 * byte first, the payload, and the exclusive or of its bytes.
 * {@code 02 02 02 02 00 00 00 09 73 52 4E 20 53 54 6C 6D 73 3A} is {@code sRN STlms}.
 */
public enum ColaDialect {
    /** Text: words separated by spaces, numbers in hexadecimal. */
    A {
        @Override
        public byte[] frame(byte[] payload) {
            ByteArrayOutputStream out = new ByteArrayOutputStream(payload.length + 2);
            out.write(STX);
            out.write(payload, 0, payload.length);
            out.write(ETX);
            return out.toByteArray();
        }
    },
    /** Command and name as text, values in binary, high byte first. */
    B {
        @Override
        public byte[] frame(byte[] payload) {
            ByteArrayOutputStream out = new ByteArrayOutputStream(payload.length + B_FRAME);
            for (int i = 0; i < STX_OF_B; i++) {
                out.write(STX);
            }
            for (int shift = 24; shift >= 0; shift -= 8) {
                out.write(payload.length >> shift);
            }
            out.write(payload, 0, payload.length);
            out.write(checksum(payload, payload.length));
            return out.toByteArray();
        }
    };

    /** First byte of a telegram. */
    static final int STX = 0x02;
    /** Last byte of a telegram of CoLa A. */
    static final int ETX = 0x03;
    /** Number of STX at the start of a telegram of CoLa B. */
    static final int STX_OF_B = 4;
    /** Number of bytes around the payload of CoLa B. */
    private static final int B_FRAME = 9;

    /** Adds the frame to a payload. */
    public abstract byte[] frame(byte[] payload);

    /** Exclusive or of the first bytes. */
    static int checksum(byte[] bytes, int count) {
        int sum = 0;
        for (int i = 0; i < count; i++) {
            sum ^= bytes[i];
        }
        return sum & 0xFF;
    }
}
