// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.io.InputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The backups beside a project, {@code SEARproject.backup-N}, at the time of listing; the highest number is the newest.
 * One thread, which holds the lock of {@link ProjectSwap}.
 */
final class Backups {
    private static final String ENDING = ".backup-";
    private static final int MOST = 10;
    /** Largest size of all backups together. */
    private static final long MAX_BYTES = 1L << 30;
    private static final int PIECE = 65536;
    /** Replaces the size of a folder, and of an entry that is not a plain file; the latter never equals another. */
    private static final long FOLDER = -1;
    private static final long OTHER = -2;
    /** Limits of the backups, for messages. */
    static final String LIMITS = "SEAR keeps the last " + MOST + " backups of a project, at most " + (MAX_BYTES >> 20)
        + " MB together";

    private final Path folder;
    private final TreeMap<Integer, Path> byNumber = new TreeMap<>();

    private Backups(Path folder) {
        this.folder = folder;
    }

    /** Lists the backups of a project. */
    static Backups of(Path folder) throws IOException {
        Backups backups = new Backups(folder);
        String start = folder.getFileName() + ENDING;
        try (Stream<Path> all = Files.list(folder.getParent())) {
            for (Path path : all.collect(Collectors.toList())) {
                String name = path.getFileName().toString();
                if (name.startsWith(start) && name.substring(start.length()).matches("[1-9][0-9]{0,8}")) {
                    backups.byNumber.put(Integer.parseInt(name.substring(start.length())), path);
                }
            }
        }
        return backups;
    }

    /** Returns the path of the next backup. */
    Path next() {
        return folder.resolveSibling(folder.getFileName() + ENDING + (byNumber.isEmpty() ? 1 : byNumber.lastKey() + 1));
    }

    List<Path> newestFirst() {
        return new ArrayList<>(byNumber.descendingMap().values());
    }

    /** Returns the backups with the same files as a folder. */
    List<Path> same(Path other) throws IOException {
        List<Path> same = new ArrayList<>();
        for (Path backup : byNumber.values()) {
            if (areSame(backup, other)) {
                same.add(backup);
            }
        }
        return same;
    }

    /** Returns the backups beyond the limits of number and size, the oldest first; never the newest. */
    List<Path> surplus() throws IOException {
        List<Path> surplus = new ArrayList<>();
        int kept = 0;
        long bytes = 0;
        for (Path backup : byNumber.descendingMap().values()) {
            bytes += bytes(backup);
            if (kept > 0 && (kept >= MOST || bytes > MAX_BYTES)) {
                surplus.add(0, backup);
            } else {
                kept++;
            }
        }
        return surplus;
    }

    /** Returns whether two folders contain the same files with the same bytes. Compares the sizes first. */
    private static boolean areSame(Path one, Path other) throws IOException {
        Map<String, Long> sizes = sizes(one);
        if (sizes.containsValue(OTHER) || !sizes.equals(sizes(other))) {
            return false;
        }
        for (Map.Entry<String, Long> file : sizes.entrySet()) {
            if (file.getValue() != FOLDER && !haveSameBytes(one.resolve(file.getKey()), other.resolve(file.getKey()))) {
                return false;
            }
        }
        return true;
    }

    /** Returns the total size of the files in a folder. */
    private static long bytes(Path folder) throws IOException {
        return sizes(folder).values().stream().mapToLong(size -> Math.max(0, size)).sum();
    }

    /** Returns the sizes by path below the folder. */
    private static Map<String, Long> sizes(Path folder) throws IOException {
        Map<String, Long> sizes = new TreeMap<>();
        Files.walkFileTree(folder, new SimpleFileVisitor<Path>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                sizes.put(folder.relativize(file).toString(), attributes.isRegularFile() ? attributes.size() : OTHER);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult preVisitDirectory(Path directory, BasicFileAttributes attributes) {
                sizes.put(folder.relativize(directory).toString(), FOLDER);
                return FileVisitResult.CONTINUE;
            }
        });
        return sizes;
    }

    /**
     * Returns a digest of all files of a folder, as text; empty if the folder contains entries other than plain files.
     */
    static String digest(Path folder) throws IOException {
        Map<String, Long> sizes = sizes(folder);
        if (sizes.containsValue(OTHER)) {
            return "";
        }
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (Map.Entry<String, Long> file : sizes.entrySet()) {
                digest.update((file.getKey() + "\n" + file.getValue() + "\n").getBytes(StandardCharsets.UTF_8));
                if (file.getValue() != FOLDER) {
                    addBytes(folder.resolve(file.getKey()), digest);
                }
            }
            return new BigInteger(1, digest.digest()).toString(Character.MAX_RADIX);
        } catch (NoSuchAlgorithmException e) {
            throw new IOException("this Java has no SHA-256", e);
        }
    }

    private static void addBytes(Path file, MessageDigest digest) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            for (byte[] piece = in.readNBytes(PIECE); piece.length > 0; piece = in.readNBytes(PIECE)) {
                digest.update(piece);
            }
        }
    }

    private static boolean haveSameBytes(Path one, Path other) throws IOException {
        try (InputStream a = Files.newInputStream(one); InputStream b = Files.newInputStream(other)) {
            byte[] piece = a.readNBytes(PIECE);
            while (piece.length > 0 && Arrays.equals(piece, b.readNBytes(PIECE))) {
                piece = a.readNBytes(PIECE);
            }
            return piece.length == 0;
        }
    }
}
