// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.problems.ProblemList;

/** Rules for the content of a bundle. They are the same for saving and loading, so every saved bundle can be loaded. */
final class BundleRules {
    /** The entry that marks a zip file as a bundle. */
    static final String VERSION_ENTRY = "sear-version.txt";
    /** Version of the format that this program writes; it reads all versions up to this one. */
    static final int VERSION = 1;
    static final int MAX_ENTRIES = 20000;
    static final long MAX_FILE = 512L << 20;
    static final long MAX_TOTAL = 1L << 30;
    /** Largest compression ratio of an entry larger than {@link #RATIO_FREE}; a higher one indicates a zip bomb. */
    static final int MAX_RATIO = 200;
    static final long RATIO_FREE = 1 << 20;
    /** Number of leading bytes that identify an archive. */
    static final int HEAD = 262;
    private static final int MAX_PATH = 200;
    private static final int MAX_DEPTH = 16;
    private static final int TAR_MARK = 257;

    private static final String[][] ARCHIVES = {
        {"PK\u0003\u0004", "zip"}, {"PK\u0005\u0006", "zip"}, {"PK\u0007\u0008", "zip"}, {"\u001f\u008b", "gzip"},
        {"7z\u00bc\u00af\u0027\u001c", "7z"},
        {"Rar!\u001a\u0007", "rar"}, {"\u00fd7zXZ\u0000", "xz"}, {"BZh", "bzip2"},
            {"\u0028\u00b5\u002f\u00fd", "zstd"}};

    private final String bundle;
    private final ProblemList problems;
    private final Map<String, String> files = new HashMap<>();
    private final Map<String, String> folders = new HashMap<>();
    private long total;
    private int entries;

    BundleRules(String bundle, ProblemList problems) {
        this.bundle = bundle;
        this.problems = problems;
    }

    private void refuse(String name, String legal) {
        problems.add(bundle, 0, "entry", name, legal);
    }

    /** Checks the name of a folder. */
    void folder(String name) {
        count();
        if (name(name)) {
            placeFolders(name, name + "/");
        }
    }

    private void count() {
        entries++;
        if (entries == MAX_ENTRIES + 1) {
            problems.add(bundle, 0, "", "too many files", "at most " + MAX_ENTRIES);
        }
    }

    /** Checks name and size of a file of the project. */
    void file(String name, long size) {
        count();
        if (name(name)) {
            place(name);
        }
        if (size > MAX_FILE) {
            refuse(name, "a file of at most " + (MAX_FILE >> 20) + " MiB; this has " + size + " bytes");
        }
        long before = total;
        total += size;
        if (total > MAX_TOTAL && before <= MAX_TOTAL) {
            problems.add(bundle, 0, "", "too large when unpacked", "at most " + (MAX_TOTAL >> 20) + " MiB in all");
        }
    }

    /** Returns the total bytes of all files so far. */
    long total() {
        return total;
    }

    private boolean name(String name) {
        String[] parts = name.split("/", -1);
        boolean legal = name.length() <= MAX_PATH && parts.length <= MAX_DEPTH;
        for (String part : parts) {
            legal &= TextRule.NAME.isLegal(part) || part.endsWith(ProjectFolder.XML)
                && TextRule.NAME.isLegal(stem(part));
        }
        if (!legal) {
            refuse(name, "a path inside the project, with forward slashes, at most " + MAX_PATH
                + " characters and " + MAX_DEPTH + " folders deep, each part " + TextRule.NAME.legal());
        }
        return legal;
    }

    private static String stem(String file) {
        return file.substring(0, file.length() - ProjectFolder.XML.length());
    }

    /** Rejects two names that some file system takes for the same, and a file whose name is also a folder. */
    private void place(String name) {
        String key = TextRule.onAnySystem(name);
        String twin = files.putIfAbsent(key, name);
        if (twin != null) {
            refuse(name, twin.equals(name) ? "each name once" : "a name that differs from " + twin
                + " by more than capitals or accents' spelling");
        }
        placeFolders(name, name);
        if (folders.containsKey(key)) {
            refuse(name, "a file that isn't a folder too");
        }
    }

    /**
     * Checks the folders of a path.
     *
     * @param name of the entry that needs them
     */
    private void placeFolders(String name, String path) {
        for (int slash = path.indexOf('/'); slash >= 0; slash = path.indexOf('/', slash + 1)) {
            String folder = path.substring(0, slash);
            String other = folders.putIfAbsent(TextRule.onAnySystem(folder), folder);
            if (other != null && !other.equals(folder)) {
                refuse(name, "a folder that differs from " + other + " by more than capitals");
            }
            if (files.containsKey(TextRule.onAnySystem(folder))) {
                refuse(name, "a folder that isn't a file too");
            }
        }
    }

    /**
     * Rejects an archive by its first bytes, since its content would not be checked. Exceptions are Blender files
     * packed by gzip or zstd and zipped elevation maps, whose readers have their own limits.
     */
    void head(String name, byte[] head, int length) {
        String start = new String(head, 0, length, StandardCharsets.ISO_8859_1);
        boolean blend = name.toLowerCase(Locale.ROOT).endsWith(".blend");
        boolean map = name.toLowerCase(Locale.ROOT).endsWith(".hgt.zip");
        for (String[] archive : ARCHIVES) {
            boolean packedBlend = blend && (archive[1].equals("gzip") || archive[1].equals("zstd"));
            boolean packedMap = map && archive[1].equals("zip");
            if (start.startsWith(archive[0]) && !packedBlend && !packedMap) {
                refuse(name, "no archive inside a bundle; this is " + archive[1]);
            }
        }
        if (start.length() >= HEAD && start.startsWith("ustar", TAR_MARK)) {
            refuse(name, "no archive inside a bundle; this is tar");
        }
    }
}
