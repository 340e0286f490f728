package org.SEAR.project.bundle;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Which entry of a bundle is which file of the project. A bundle that saveProject made has its version at the top, and its names are meant as they
 * stand. Every other one is taken for a SEARproject that somebody zipped and renamed, as section 5.1 of the dissertation says: with all of it below
 * one folder {@code SEARproject/} or without that, and with what the zip programs of other systems add or write differently.
 */
final class BundleLayout {
    private static final String FOLDER = "SEARproject/";
    /** Where macOS keeps what other systems' files don't have: {@code __MACOSX/SEARproject/._robot}. */
    private static final String MAC = "__macosx";
    /** Files that Windows puts to folders by itself. */
    private static final Set<String> WINDOWS = Set.of("thumbs.db", "desktop.ini");

    private final boolean own;
    private final List<ZipDirectory.Entry> entries = new ArrayList<>();

    /** Gives the entries of a foreign zip file the names that they have in the project. */
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

    /** Some of Windows' programs separate folders by backslashes; macOS spells an accented letter as two characters. */
    private static String name(ZipDirectory.Entry entry) {
        boolean windows = entry.isFromWindows() && entry.name.indexOf('/') < 0;
        return Normalizer.normalize(windows ? entry.name.replace('\\', '/') : entry.name, Normalizer.Form.NFC);
    }

    /** Whether a file belongs to a system or a tool and not to the project; saveProject leaves such files out, too. */
    private static boolean isSystems(String name) {
        String[] parts = name.toLowerCase(Locale.ROOT).split("/");
        for (String part : parts) {
            if (part.startsWith(".") && part.matches("\\.\\.?[^.].*")) {
                return true;
            }
        }
        return parts.length > 0 && (parts[0].equals(MAC) || WINDOWS.contains(parts[parts.length - 1]));
    }

    /** Whether saveProject made the bundle. */
    boolean isOwn() {
        return own;
    }

    /** All that belongs to the project, folders and the version entry as well. */
    List<ZipDirectory.Entry> entries() {
        return entries;
    }

    /** The entry with the format's version; null if there is none, which is the dissertation's format. */
    ZipDirectory.Entry version() {
        return entries.stream().filter(entry -> entry.name.equals(BundleRules.VERSION_ENTRY)).findFirst().orElse(null);
    }
}
