package org.SEAR.project;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Map;
import java.util.TreeMap;

/** Whether two folders hold the same files with the same bytes. Looks at sizes first. Any thread. */
final class SameFiles {
    private static final int BUFFER = 65536;

    private SameFiles() {
    }

    static boolean in(Path one, Path other) throws IOException {
        Map<String, Long> sizes = sizes(one);
        if (!sizes.equals(sizes(other))) {
            return false;
        }
        for (String file : sizes.keySet()) {
            if (!haveSameBytes(one.resolve(file), other.resolve(file))) {
                return false;
            }
        }
        return true;
    }

    /** By path below the folder; -1 for a folder and for whatever is no plain file. */
    private static Map<String, Long> sizes(Path folder) throws IOException {
        Map<String, Long> sizes = new TreeMap<>();
        Files.walkFileTree(folder, new SimpleFileVisitor<Path>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                sizes.put(folder.relativize(file).toString(), attributes.isRegularFile() ? attributes.size() : -1);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult preVisitDirectory(Path directory, BasicFileAttributes attributes) {
                sizes.put(folder.relativize(directory).toString(), -1L);
                return FileVisitResult.CONTINUE;
            }
        });
        return sizes;
    }

    private static boolean haveSameBytes(Path one, Path other) throws IOException {
        if (Files.isDirectory(one, LinkOption.NOFOLLOW_LINKS) || Files.isDirectory(other, LinkOption.NOFOLLOW_LINKS)) {
            return Files.isDirectory(one, LinkOption.NOFOLLOW_LINKS) && Files.isDirectory(other, LinkOption.NOFOLLOW_LINKS);
        }
        if (!Files.isRegularFile(one, LinkOption.NOFOLLOW_LINKS) || !Files.isRegularFile(other, LinkOption.NOFOLLOW_LINKS)) {
            return false;
        }
        try (InputStream a = new BufferedInputStream(Files.newInputStream(one), BUFFER);
             InputStream b = new BufferedInputStream(Files.newInputStream(other), BUFFER)) {
            int value = a.read();
            while (value >= 0 && value == b.read()) {
                value = a.read();
            }
            return value < 0;
        }
    }
}
