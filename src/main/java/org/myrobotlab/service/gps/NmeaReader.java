package org.myrobotlab.service.gps;

import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/**
 * Finds NMEA 0183 sentences in a stream of bytes: {@code $GPGGA,...*5F CR LF}, the check sum being the exclusive or of what stands between
 * {@code $} and {@code *}. Damaged sentences are counted and left out; reading goes on at the next {@code $}. Any one thread at a time.
 */
public final class NmeaReader {
    /** Longest sentence taken: NMEA allows 82, receivers' own sentences are longer. */
    private static final int LONGEST = 256;
    private static final int HEX = 16;

    private final Consumer<String> sentences;
    private final byte[] buffer = new byte[LONGEST];
    private int filled;
    private long damaged;

    /** @param sentences gets each good sentence, from {@code $} to check sum, without line end; those without check sum too */
    public NmeaReader(Consumer<String> sentences) {
        this.sentences = sentences;
    }

    /** Takes bytes as they come, in pieces of any size. */
    public void feed(byte[] bytes) {
        for (byte b : bytes) {
            if (b == '$') {
                damaged += filled > 0 ? 1 : 0;
                filled = 0;
                buffer[filled++] = b;
            } else if (b == '\r' || b == '\n') {
                end();
            } else if (filled > 0) {
                append(b);
            }
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

    /** Sentences ever left out because their check sum was wrong or bytes were missing. */
    public long getDamaged() {
        return damaged;
    }

    /** Forgets a sentence that was begun. */
    public void reset() {
        filled = 0;
    }

    /** A sentence with check sum and line end: {@code "PMTK220,200"} becomes {@code "$PMTK220,200*2C\r\n"}. */
    public static String framed(String body) {
        return String.format("$%s*%02X\r\n", body, checksum(body));
    }

    private static boolean isGood(String sentence) {
        int star = sentence.lastIndexOf('*');
        if (star < 0) {
            return sentence.startsWith("$P");
        }
        String given = sentence.substring(star + 1);
        return given.matches("[0-9A-Fa-f]{2}") && Integer.parseInt(given, HEX) == checksum(sentence.substring(1, star));
    }

    private static int checksum(String body) {
        int sum = 0;
        for (int i = 0; i < body.length(); i++) {
            sum ^= body.charAt(i);
        }
        return sum;
    }
}
