// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;

/** Unpacks a bundle into an empty folder, after checking its whole directory. One use. */
final class BundleReader {
    private static final int BLOCK = 1 << 16;
    private static final int LONGEST_VERSION = 20;
    private static final Pattern OBJECT =
        Pattern.compile("(" + ProjectFolder.ENVIRONMENT + "|" + ProjectFolder.ROBOT + ")/[^/]+"
        + Pattern.quote(ProjectFolder.XML));
    private static final Pattern INNER_OBJECT = Pattern.compile(".+/" + OBJECT.pattern());

    private final Path bundle;
    private final String name;
    private final Progress progress;
    private final ProblemList problems = new ProblemList();
    private final BundleRules rules;
    private long done;

    BundleReader(Path bundle, Progress progress) {
        this.bundle = bundle;
        this.name = bundle.getFileName().toString();
        this.progress = progress;
        this.rules = new BundleRules(name, problems);
    }

    /** Returns whether there is a file with an ending, in lower case. */
    boolean hasFile(String ending) throws IOException, ProjectException {
        try (FileChannel channel = FileChannel.open(bundle)) {
            List<ZipDirectory.Entry> entries = new ZipDirectory(channel, name, problems).read();
            problems.throwIfAny();
            return entries.stream().anyMatch(entry -> entry.name.toLowerCase(Locale.ROOT).endsWith(ending));
        }
    }

    /** Unpacks any zip file: neither a version nor objects are needed. */
    void unpackFiles(Path folder) throws IOException, ProjectException {
        try (FileChannel channel = FileChannel.open(bundle)) {
            List<ZipDirectory.Entry> entries = new ZipDirectory(channel, name, problems).read();
            problems.throwIfAny();
            BundleLayout layout = new BundleLayout(entries);
            checkNames(layout);
            problems.throwIfAny();
            for (ZipDirectory.Entry entry : layout.entries()) {
                if (!entry.isFolder()) {
                    extract(channel, entry, folder.resolve(entry.name));
                }
            }
            problems.throwIfAny();
        }
    }

    void unpack(Path folder) throws IOException, ProjectException {
        if (!Files.isRegularFile(bundle)) {
            problems.add(bundle.toString(), 0, "", "there is no such file", "a .sear file");
            problems.throwIfAny();
        }
        try (FileChannel channel = FileChannel.open(bundle)) {
            List<ZipDirectory.Entry> entries = new ZipDirectory(channel, name, problems).read();
            problems.throwIfAny();
            BundleLayout layout = new BundleLayout(entries);
            entries = layout.entries();
            ZipDirectory.Entry version = layout.version();
            checkNames(layout);
            if (version != null) {
                checkVersion(channel, version);
            }
            checkPlace(entries, version != null);
            problems.throwIfAny();
            for (ZipDirectory.Entry entry : entries) {
                if (entry != version && !entry.isFolder()) {
                    extract(channel, entry, folder.resolve(entry.name));
                }
            }
            problems.throwIfAny();
        }
    }

    private void checkNames(BundleLayout layout) {
        for (ZipDirectory.Entry entry : layout.entries()) {
            if (layout.isOwn() && entry.isNameUnmarked()) {
                refuse(entry, "a name in ASCII, or in UTF-8 and marked so");
            }
            if (entry.isFolder()) {
                rules.folder(entry.name.substring(0, entry.name.length() - 1));
            } else {
                rules.file(entry.name, entry.size);
            }
        }
    }

    /**
     * Rejects a zip file without objects at the top, which would open as an empty world: a project zipped with one more
     * folder, or another kind of zip file.
     */
    private void checkPlace(List<ZipDirectory.Entry> entries, boolean hasVersion) {
        ZipDirectory.Entry inner = null;
        for (ZipDirectory.Entry entry : entries) {
            if (OBJECT.matcher(entry.name).matches()) {
                return;
            }
            if (inner == null && INNER_OBJECT.matcher(entry.name).matches()) {
                inner = entry;
            }
        }
        if (inner != null) {
            refuse(inner, "environment, robot and assets at the top of the bundle, not in a folder of it");
        } else if (!hasVersion) {
            problems.add(name, 0, "", "it has no " + BundleRules.VERSION_ENTRY + " and no object",
                "a bundle that saveProject made, or a SEARproject"
                + " folder that was zipped: environment, robot and assets at the top or below one folder SEARproject");
        }
    }

    private void checkVersion(FileChannel channel, ZipDirectory.Entry version) throws IOException {
        String text = "";
        if (version.size <= LONGEST_VERSION) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            copy(channel, version, out);
            text = new String(out.toByteArray(), StandardCharsets.UTF_8).trim();
        }
        if (!text.matches("[1-9][0-9]{0,8}")) {
            problems.add(name, 0, "version", text, "a whole number");
        } else if (Integer.parseInt(text) > BundleRules.VERSION) {
            problems.add(name, 0, "version", text, "1 to " + BundleRules.VERSION + "; a newer SEAR made this bundle "
                + "and can open it");
        }
    }

    private void extract(FileChannel channel, ZipDirectory.Entry entry, Path file) throws IOException {
        Files.createDirectories(file.getParent());
        try (OutputStream out = Files.newOutputStream(file)) {
            copy(channel, entry, out);
        }
        progress.at(entry.name, done, rules.total());
    }

    /** Copies an entry's content; stops as soon as the content exceeds the declared size. */
    private void copy(FileChannel channel, ZipDirectory.Entry entry, OutputStream out) throws IOException {
        Content content = new Content(entry, out);
        Inflater inflater = new Inflater(true);
        try {
            ByteBuffer block = ByteBuffer.allocate(BLOCK);
            byte[] plain = new byte[BLOCK];
            long left = entry.packed;
            while (left > 0 && content.isGood()) {
                block.clear().limit((int) Math.min(BLOCK, left));
                int got = channel.read(block, entry.dataStart + entry.packed - left);
                if (got <= 0) {
                    throw new IOException(name + " became shorter while it was read");
                }
                left -= got;
                if (entry.method == ZipDirectory.STORED) {
                    content.add(block.array(), got);
                } else {
                    inflater.setInput(block.array(), 0, got);
                    inflate(inflater, plain, content);
                }
            }
            content.finish(entry.method == ZipDirectory.STORED || inflater.finished());
        } catch (DataFormatException e) {
            refuse(entry, "whole content; this can't be unpacked (" + e.getMessage() + ")");
        } finally {
            inflater.end();
        }
    }

    private static void inflate(Inflater inflater, byte[] plain, Content content)
        throws DataFormatException, IOException {
        while (!inflater.needsInput() && !inflater.finished() && content.isGood()) {
            int length = inflater.inflate(plain);
            if (length == 0 && inflater.needsDictionary()) {
                throw new DataFormatException("a dictionary is needed");
            }
            content.add(plain, length);
        }
    }

    private void refuse(ZipDirectory.Entry entry, String legal) {
        problems.add(name, 0, "entry", entry.name, legal);
    }

    /** Checks the content of one entry while it is written. */
    private final class Content {
        private final ZipDirectory.Entry entry;
        private final OutputStream out;
        private final CRC32 crc = new CRC32();
        private final byte[] head = new byte[BundleRules.HEAD];
        private int headLength;
        private long size;
        private boolean good = true;

        Content(ZipDirectory.Entry entry, OutputStream out) {
            this.entry = entry;
            this.out = out;
        }

        boolean isGood() {
            return good;
        }

        void add(byte[] bytes, int length) throws IOException {
            size += length;
            if (size > entry.size) {
                refuse(entry, "at most the " + entry.size + " bytes of the directory's record");
                good = false;
                return;
            }
            int first = Math.min(length, head.length - headLength);
            System.arraycopy(bytes, 0, head, headLength, first);
            headLength += first;
            crc.update(bytes, 0, length);
            out.write(bytes, 0, length);
            long megabytes = done >> 22;
            done += length;
            if (done >> 22 != megabytes) {
                progress.at(entry.name, done, rules.total());
            }
        }

        void finish(boolean complete) {
            if (good && (!complete || size != entry.size || crc.getValue() != entry.crc)) {
                refuse(entry, "whole content; this is damaged");
            }
            rules.head(entry.name, head, headLength);
        }
    }
}
