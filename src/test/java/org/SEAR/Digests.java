// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.Reading;

/**
 * Checksums of everything a run produces. {@code src/test/resources/digests.txt} has the checksums of the examples, one
 * per line: name, checksum, description. A change of bytes therefore shows in the diff of its commit.
 */
public final class Digests {
    private static final Path FILE = Path.of(System.getProperty("sear.root", "."), "src/test/resources/digests.txt");
    private static final int DIGITS = 16;

    private Digests() {
    }

    public static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("this Java has no SHA-256", e);
        }
    }

    /** Returns the first digits of the digest and resets it. */
    public static String hex(MessageDigest digest) {
        return String.format("%064x", new BigInteger(1, digest.digest())).substring(0, DIGITS);
    }

    public static String hex(Path file) throws IOException {
        MessageDigest digest = sha256();
        digest.update(Files.readAllBytes(file));
        return hex(digest);
    }

    private static void put(MessageDigest digest, double value) {
        digest.update(ByteBuffer.allocate(Double.BYTES).putDouble(value).array());
    }

    /** Adds all numbers of a reading, including each beam and each pixel. */
    public static void put(MessageDigest digest, Reading reading) {
        for (double value : reading.numbers()) {
            put(digest, value);
        }
        if (reading instanceof LidarScan) {
            for (double range : ((LidarScan) reading).ranges()) {
                put(digest, range);
            }
        } else if (reading instanceof CameraImage) {
            CameraImage image = (CameraImage) reading;
            int[] pixels = image.getPixels();    // a copy
            float[] values = image.getValues();
            for (int i = 0; i < image.getWidth() * image.getHeight(); i++) {
                put(digest, pixels == null ? values[i] : pixels[i]);
            }
        }
    }

    /** Fails unless the digest of an example equals the listed one. */
    public static void assertSame(String name, String digest) throws IOException {
        String listed = Files.readAllLines(FILE).stream().filter(line -> line.startsWith(name + " "))
            .map(line -> line.split(" +")[1]).findFirst().orElse("not there");
        assertEquals("what " + name + " gives, in " + FILE + ": bytes of a port or readings of a sensor are others. If "
            + "that is meant, write it there", listed, digest);
    }
}
