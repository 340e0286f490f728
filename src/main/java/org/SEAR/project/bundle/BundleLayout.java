// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Mapping of bundle entries to files of the project. A bundle by saveProject has its version at the top, and its names
 * are used as they are. Any other zip file is taken for a zipped and renamed SEARproject (dissertation, section 5.1):
 * its files lie at the top or below one folder {@code SEARproject/}, and may include additions and name variants of
 * other systems' zip programs.
 */
final class BundleLayout {
    private static final String FOLDER = "SEARproject/";
    /** Folder of macOS for data that other systems don't have: {@code __MACOSX/SEARproject/._robot}. */
    private static final String MAC = "__macosx";
    /** Files that Windows adds to folders. */
    private static final Set<String> WINDOWS = Set.of("thumbs.db", "desktop.ini");

    private final boolean own;
    private final List<ZipDirectory.Entry> entries = new ArrayList<>();

    /** Renames the entries of a foreign zip file to their names in the project. */
    BundleLayout(List<ZipDirectory.Entry> all) {
        own = all.stream().anyMatch(entry -> entry.name.equals(BundleRules.VERSION_ENTRY));
        if (own) {
            entries.addAll(all);
            return;
        }
        for (ZipDirectory.Entry entry : all) {
            entry.name = name(entry);
            if (!isSystems(entry.name)) {
                entries.add(entry);
            }
        }
        if (entries.stream().allMatch(entry -> entry.name.startsWith(FOLDER))) {
            entries.forEach(entry -> entry.name = entry.name.substring(FOLDER.length()));
            entries.removeIf(entry -> entry.name.isEmpty());
        }
    }

    /**
     * Returns the normalised name: some Windows programs separate folders by backslashes, and macOS writes an accented
     * letter as two characters.
     */
    private static String name(ZipDirectory.Entry entry) {
        boolean windows = entry.isFromWindows() && entry.name.indexOf('/') < 0;
        return Normalizer.normalize(windows ? entry.name.replace('\\', '/') : entry.name, Normalizer.Form.NFC);
    }

    /** Returns whether a file belongs to a system or a tool, not to the project; saveProject also skips such files. */
    private static boolean isSystems(String name) {
        String[] parts = name.toLowerCase(Locale.ROOT).split("/");
        for (String part : parts) {
            if (part.startsWith(".") && part.matches("\\.\\.?[^.].*")) {
                return true;
            }
        }
        return parts.length > 0 && (parts[0].equals(MAC) || WINDOWS.contains(parts[parts.length - 1]));
    }

    /** Returns whether saveProject created the bundle. */
    boolean isOwn() {
        return own;
    }

    /** Returns all entries of the project, including folders and the version entry. */
    List<ZipDirectory.Entry> entries() {
        return entries;
    }

    /** Returns the entry with the format's version; null for the dissertation's format, which has none. */
    ZipDirectory.Entry version() {
        return entries.stream().filter(entry -> entry.name.equals(BundleRules.VERSION_ENTRY)).findFirst().orElse(null);
    }
}
