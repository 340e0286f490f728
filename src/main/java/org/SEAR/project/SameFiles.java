package org.SEAR.project;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;

/** Whether two folders hold the same files with the same bytes. Looks at sizes first. Any thread. */
final class SameFiles {
    private static final int PIECE = 65536;
    /** In the place of a size: a folder, and whatever is no plain file, which is never the same. */
    private static final long FOLDER = -1;
    private static final long OTHER = -2;

    private SameFiles() {
    }

    static boolean in(Path one, Path other) throws IOException {
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

    /** How many there are in a folder, all told. */
    static long bytes(Path folder) throws IOException {
        return sizes(folder).values().stream().mapToLong(size -> Math.max(0, size)).sum();
    }

    /** By path below the folder. */
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
