// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Bundles in parts, to and from a panel. */
public class BundleTransfersTest {
    private final byte[] bundle = new byte[2 * BundleTransfers.PART + 17];
    private byte[] loaded;
    private final BundleTransfers transfers = new BundleTransfers(file -> Files.write(file, bundle), file -> loaded =
        Files.readAllBytes(file));

    public BundleTransfersTest() {
        new Random(1).nextBytes(bundle);
    }

    @Test
    public void aDownloadInPartsIsTheBundle() throws Exception {
        ByteArrayOutputStream whole = new ByteArrayOutputStream();
        int count = 1;
        for (int i = 0; i < count; i++) {
            Map<String, Object> part = transfers.part(i);
            count = (Integer) part.get("count");
            whole.write(Base64.getDecoder().decode((String) part.get("data")));
        }
        assertEquals(3, count);
        assertArrayEquals(bundle, whole.toByteArray());
    }

    @Test
    public void anUploadInPartsIsLoadedWithTheLast() throws Exception {
        assertFalse(transfers.receive("my.sear", 0, 2, base64(0, 1000)));
        assertTrue(transfers.receive("my.sear", 1, 2, base64(1000, 1500)));
        assertArrayEquals(Arrays.copyOf(bundle, 1500), loaded);
    }

    @Test
    public void partsOutOfOrderAreRejectedAndANewStartDropsTheOldOne() throws Exception {
        transfers.receive("my.sear", 0, 3, base64(0, 10));
        assertRefused("arrived out of order, expected 1", () -> transfers.receive("my.sear", 2, 3, base64(0, 10)));
        assertTrue(transfers.receive("other.sear", 0, 1, base64(0, 5)));
        assertEquals(5, loaded.length);
    }

    /** A program with 32 MB of memory that uploads and downloads 64 MB. */
    @Test
    @Category(Slow.class)
    public void aBundleLargerThanTheMemoryIsTransferred() throws Exception {
        List<String> command = SearProcess.java("", new String[] {"-Xmx32m"});
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), Large.class.getName()));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(text, 0, process.waitFor());
        assertEquals("67108864 bytes loaded, 67108864 bytes saved\n", text);
    }

    /** The program of {@link #aBundleLargerThanTheMemoryIsTransferred}. */
    public static final class Large {
        private Large() {
        }

        public static void main(String[] arguments) throws Exception {
            Path kept = Files.createTempFile("large", ".sear");
            BundleTransfers transfers = new BundleTransfers(file -> Files.copy(kept, file),
                file -> Files.move(file, kept, StandardCopyOption.REPLACE_EXISTING));
            String part = Base64.getEncoder().encodeToString(new byte[1 << 20]);
            for (int i = 0; i < 64; i++) {
                transfers.receive("large.sear", i, 64, part);
            }
            long saved = 0;
            int count = 1;
            for (int i = 0; i < count; i++) {
                Map<String, Object> sent = transfers.part(i);
                count = (Integer) sent.get("count");
                saved += Base64.getDecoder().decode((String) sent.get("data")).length;
            }
            System.out.print(Files.size(kept) + " bytes loaded, " + saved + " bytes saved\n");
            Files.delete(kept);
        }
    }

    @Test
    public void aFailedOrRefusedUploadStartsAgainWithPartZero() throws Exception {
        transfers.receive("my.sear", 0, 2, base64(0, 10));
        assertRefused("was damaged in transfer", () -> transfers.receive("my.sear", 1, 2, "?"));
        assertTrue(transfers.receive("my.sear", 0, 1, base64(0, 7)));
        assertRefused("arrived out of order, expected 0", () -> transfers.receive("my.sear", 1, 2, base64(0, 7)));
        assertEquals(7, loaded.length);
    }

    @Test
    public void damagedPartsAreRefused() {
        assertRefused("was damaged in transfer", () -> transfers.receive("my.sear", 0, 1, "?"));
        assertRefused("part is 3, legal: 0 to 0", () -> transfers.part(3));
    }

    private String base64(int from, int to) {
        return Base64.getEncoder().encodeToString(Arrays.copyOfRange(bundle, from, to));
    }

    private interface Call {
        void run() throws Exception;
    }

    private static void assertRefused(String message, Call call) {
        try {
            call.run();
        } catch (Exception e) {
            assertTrue(e.getMessage(), e.getMessage().contains(message));
            return;
        }
        throw new AssertionError("was not refused: " + message);
    }
}
