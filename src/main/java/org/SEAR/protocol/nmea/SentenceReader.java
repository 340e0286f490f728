// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.nmea;

import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/**
 * Finds NMEA 0183 sentences in a stream of bytes: {@code $GPGGA,...*5F CR LF}. Counts and skips damaged sentences;
 * reading continues at the next {@code $}. One thread at a time.
 */
public final class SentenceReader {
    /** Longest accepted sentence, bytes: NMEA permits 82, proprietary sentences are longer. */
    private static final int LONGEST = 256;

    private final Consumer<String> sentences;
    private final byte[] buffer = new byte[LONGEST];
    private int filled;
    private long damaged;

    /**
     * @param sentences receives each valid sentence, from {@code $} to checksum, without line end; also proprietary
     *     ones ({@code $P...}) without checksum
     */
    public SentenceReader(Consumer<String> sentences) {
        this.sentences = sentences;
    }

    /** Takes bytes in pieces of any size. */
    public void feed(byte[] bytes) {
        for (byte b : bytes) {
            accept(b);
        }
    }

    /**
     * Takes the next byte.
     *
     * @param value only its low eight bits count
     */
    public void accept(int value) {
        if (value == '$') {
            damaged += filled > 0 ? 1 : 0;
            filled = 0;
            buffer[filled++] = '$';
        } else if (value == '\r' || value == '\n') {
            end();
        } else if (filled > 0) {
            append((byte) value);
        }
    }

    private void append(byte b) {
        if (filled == LONGEST || b < ' ' || b > '~') {
            damaged++;
            filled = 0;
        } else {
            buffer[filled++] = b;
        }
    }

    private void end() {
        if (filled > 0) {
            String sentence = new String(buffer, 0, filled, StandardCharsets.US_ASCII);
            filled = 0;
            if (isGood(sentence)) {
                sentences.accept(sentence);
            } else {
                damaged++;
            }
        }
    }

    /** Total number of skipped sentences with a wrong checksum or missing bytes. */
    public long getDamaged() {
        return damaged;
    }

    /** Discards an incomplete sentence. */
    public void reset() {
        filled = 0;
    }

    private static boolean isGood(String sentence) {
        return sentence.indexOf('*') < 0 ? sentence.startsWith("$P") : Nmea.body(sentence) != null;
    }
}
