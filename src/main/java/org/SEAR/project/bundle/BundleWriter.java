// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.LocalDateTime;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;

/** Packs a project folder; the same files always give the same bytes. One use. */
final class BundleWriter {
    /** Time of every entry: the earliest that a zip file can represent. */
    private static final LocalDateTime EPOCH = LocalDateTime.of(1980, 1, 1, 0, 0);
    private static final int BLOCK = 1 << 16;

    private final Path folder;
    private final Progress progress;
    private final ProblemList problems = new ProblemList();
    private final BundleRules rules;
    private final Map<String, Path> files = new TreeMap<>();
    private final Map<String, Path> instead = new TreeMap<>();
    private long done;

    BundleWriter(Path folder, String bundle, Progress progress) {
        this.folder = folder;
        this.progress = progress;
        this.rules = new BundleRules(bundle, problems);
    }

    /**
     * Replaces files of the folder.
     *
     * @param others files by their names in the bundle; null to leave a file out
     */
    BundleWriter with(Map<String, Path> others) {
        instead.putAll(others);
        return this;
    }

    void write(Path target) throws IOException, ProjectException {
        collect();
        for (Map.Entry<String, Path> other : instead.entrySet()) {
            if (other.getValue() != null) {
                take(other.getKey(), other.getValue());
            }
        }
        problems.throwIfAny();
        try (FileChannel channel = FileChannel.open(target, StandardOpenOption.WRITE, StandardOpenOption.CREATE,
                    StandardOpenOption.TRUNCATE_EXISTING);
                ZipOutputStream zip = new ZipOutputStream(
                    new BufferedOutputStream(Channels.newOutputStream(channel), BLOCK))) {
            start(zip, BundleRules.VERSION_ENTRY);
            zip.write((BundleRules.VERSION + "\n").getBytes(StandardCharsets.US_ASCII));
            zip.closeEntry();
            for (Map.Entry<String, Path> file : files.entrySet()) {
                pack(zip, file.getKey(), file.getValue());
            }
            zip.finish();
            zip.flush();
            channel.force(true);
        }
    }

    /** Collects all files except hidden ones, which belong to the system or to tools. */
    private void collect() throws IOException {
        Files.walkFileTree(folder, new SimpleFileVisitor<Path>() {
            @Override
            public FileVisitResult preVisitDirectory(Path directory, BasicFileAttributes attributes) {
                boolean hidden = !directory.equals(folder) && directory.getFileName().toString().startsWith(".");
                return hidden ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                if (!file.getFileName().toString().startsWith(".")) {
                    add(file, attributes);
                }
                return FileVisitResult.CONTINUE;
            }
        });
    }

    private void add(Path file, BasicFileAttributes attributes) throws IOException {
        String name = folder.relativize(file).toString().replace(file.getFileSystem().getSeparator(), "/");
        if (!attributes.isRegularFile()) {
            problems.add(name, 0, "", "it is a link or a device", "an ordinary file; copy what it points to");
            return;
        }
        if (name.equalsIgnoreCase(BundleRules.VERSION_ENTRY)) {
            addVersion(name, file);
            return;
        }
        if (!instead.containsKey(name)) {
            take(name, file);
        }
    }

    /** Skips the version file of a bundle that was unpacked by hand; every bundle gets its own. */
    private void addVersion(String name, Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            String text = new String(in.readNBytes(BundleRules.HEAD), StandardCharsets.US_ASCII).trim();
            if (!text.matches("[0-9]{1,9}")) {
                problems.add(name, 0, "", "it has the name of the bundle's own version entry", "another name");
            }
        }
    }

    private void take(String name, Path file) throws IOException {
        rules.file(name, Files.size(file));
        byte[] head = new byte[BundleRules.HEAD];
        try (InputStream in = Files.newInputStream(file)) {
            rules.head(name, head, in.readNBytes(head, 0, head.length));
        }
        files.put(name, file);
    }

    private static void start(ZipOutputStream zip, String name) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTimeLocal(EPOCH);
        zip.putNextEntry(entry);
    }

    private void pack(ZipOutputStream zip, String name, Path file) throws IOException {
        zip.setLevel(packsTooWell(file) ? Deflater.NO_COMPRESSION : Deflater.DEFAULT_COMPRESSION);
        start(zip, name);
        try (InputStream in = Files.newInputStream(file)) {
            byte[] block = new byte[BLOCK];
            for (int length = in.read(block); length >= 0; length = in.read(block)) {
                zip.write(block, 0, length);
                long megabytes = done >> 22;
                done += length;
                if (done >> 22 != megabytes) {
                    progress.at(name, done, rules.total());
                }
            }
        }
        zip.closeEntry();
        progress.at(name, done, rules.total());
    }

    /** Returns whether the reader would take the packed file for a zip bomb. */
    private static boolean packsTooWell(Path file) throws IOException {
        long size = Files.size(file);
        if (size <= BundleRules.RATIO_FREE) {
            return false;
        }
        Deflater deflater = new Deflater(Deflater.DEFAULT_COMPRESSION, true);
        try (InputStream in = Files.newInputStream(file)) {
            byte[] plain = new byte[BLOCK];
            byte[] packed = new byte[BLOCK];
            for (int length = in.read(plain); length >= 0; length = in.read(plain)) {
                deflater.setInput(plain, 0, length);
                while (!deflater.needsInput()) {
                    deflater.deflate(packed);
                }
            }
            deflater.finish();
            while (!deflater.finished()) {
                deflater.deflate(packed);
            }
            return size / Math.max(1, deflater.getBytesWritten()) > BundleRules.MAX_RATIO / 2;
        } finally {
            deflater.end();
        }
    }
}
