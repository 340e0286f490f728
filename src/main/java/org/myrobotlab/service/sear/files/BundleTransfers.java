// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Transfers bundles to and from a panel in a browser, in parts that fit MyRobotLab's messages (1 MiB). One upload and
 * one download at a time, each in a temporary file; a new one replaces the previous. Memory holds one part. Any thread.
 */
public final class BundleTransfers {
    /** Bytes of a part sent to a panel. */
    static final int PART = 192 * 1024;
    /** Bytes of the largest bundle that panels may send, on the disk. */
    private static final int GREATEST = 256 * 1024 * 1024;
    private static final String DOWNLOAD = "project.sear";
    /** Characters; file systems allow 255 bytes. */
    private static final int LONGEST_NAME = 60;

    private final Work save;
    private final Work load;
    private int expected;
    /** Contains the upload and the download; null before the first of them. */
    private Path folder;

    /** An action on a bundle's file. */
    public interface Work {
        /** @throws Exception with the reason of a failure */
        void on(Path bundle) throws Exception;
    }

    /**
     * @param save writes the project as a bundle
     * @param load replaces the project with a bundle
     */
    public BundleTransfers(Work save, Work load) {
        this.save = save;
        this.load = load;
    }

    /**
     * Takes the next part of a bundle; the last one replaces the project.
     *
     * @param name file name on the user's computer
     * @param index from 0, in order
     * @param count number of parts
     * @param base64 the part
     * @return whether this was the last part
     */
    public synchronized boolean receive(String name, int index, int count, String base64) throws Exception {
        Path upload = file("upload");
        if (index == 0) {
            Files.deleteIfExists(upload);
            expected = 0;
        }
        if (index != expected || index >= count) {
            throw new IllegalArgumentException("part " + index + " of " + count + " of " + name
                + " arrived out of order, expected " + expected + ": upload the file again");
        }
        byte[] part = decoded(name, base64);
        if (index > 0 && Files.size(upload) + part.length > GREATEST) {
            Files.delete(upload);
            expected = 0;
            throw new IllegalArgumentException(name + " is larger than " + GREATEST
                + " bytes: copy it into MyRobotLab's folder and open its path");
        }
        Files.write(upload, part, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        expected++;
        if (expected < count) {
            return false;
        }
        expected = 0;
        withFile(fileName(name), file -> {
            Files.move(upload, file);
            load.on(file);
        });
        return true;
    }

    /** Returns a file in a folder that only this user can read, and that is deleted at the end of this program. */
    private Path file(String name) throws IOException {
        if (folder == null || !Files.isDirectory(folder)) {
            folder = Files.createTempDirectory("sear-transfer");
            folder.toFile().deleteOnExit();
            folder.resolve("upload").toFile().deleteOnExit();
            folder.resolve("download").toFile().deleteOnExit();
        }
        return folder.resolve(name);
    }

    /** Returns the user's file name without characters illegal here; errors and progress show it. */
    private static String fileName(String name) {
        String last = name == null ? "" : name.replaceAll(".*[/\\\\]", "")
            .replaceAll("[\\p{Cntrl}:*?\"<>|]", "_").trim();
        return last.replace(".", "").isEmpty() ? DOWNLOAD : last.substring(Math.max(0, last.length() - LONGEST_NAME));
    }

    private static byte[] decoded(String name, String base64) {
        try {
            return Base64.getDecoder().decode(base64);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(name + " was damaged in transfer (" + e.getMessage()
                + "): upload the file again", e);
        }
    }

    /**
     * Returns a part of the project's bundle; the first part creates the bundle.
     *
     * @return {@code {"index", "count", "data"}}, data in base64
     */
    public synchronized Map<String, Object> part(int index) throws Exception {
        if (index == 0) {
            withFile(DOWNLOAD, this::keep);
        }
        Path download = file("download");
        long size = Files.exists(download) ? Files.size(download) : 0;
        int count = (int) Math.max(1, (size + PART - 1) / PART);
        if (index < 0 || index >= count) {
            throw new IllegalArgumentException("part is " + index + ", legal: 0 to " + (count - 1));
        }
        Map<String, Object> part = new LinkedHashMap<>();
        part.put("index", index);
        part.put("count", count);
        byte[] bytes = new byte[(int) Math.max(0, Math.min(size - (long) index * PART, PART))];
        if (size > 0) {
            try (RandomAccessFile from = new RandomAccessFile(download.toFile(), "r")) {
                from.seek((long) index * PART);
                from.readFully(bytes);
            }
        }
        part.put("data", Base64.getEncoder().encodeToString(bytes));
        return part;
    }

    private synchronized void keep(Path file) throws Exception {
        save.on(file);
        Files.move(file, file("download"), StandardCopyOption.REPLACE_EXISTING);
    }

    private static void withFile(String name, Work work) throws Exception {
        Path folder = Files.createTempDirectory("sear");
        Path file = folder.resolve(name);
        try {
            work.on(file);
        } finally {
            Files.deleteIfExists(file);
            deleteEmpty(folder);
        }
    }

    private static void deleteEmpty(Path folder) throws IOException {
        String[] left = folder.toFile().list();
        if (left == null || left.length == 0) {
            Files.delete(folder);
        }
    }
}
