// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.classroom;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The names of a class: a file with one name a line; empty lines and lines that begin with # are ignored. */
final class Roster {
    private static final int LONGEST = 60;
    private static final String MARK = "\uFEFF";

    private Roster() {
    }

    /**
     * Reads the file.
     *
     * @return folder names by pupils' names, in the order of the file
     * @throws IllegalArgumentException if a name is invalid, or two names give the same folder
     */
    static Map<String, String> read(Path file) throws IOException {
        Map<String, String> folders = new LinkedHashMap<>();
        Map<String, String> taken = new LinkedHashMap<>();
        List<String> wrong = new ArrayList<>();
        int number = 0;
        for (String line : Files.readString(file, StandardCharsets.UTF_8).replace(MARK, "").split("\\R")) {
            String name = line.trim();
            number++;
            if (name.isEmpty() || name.startsWith("#")) {
                continue;
            }
            String folder = folder(name);
            String other = taken.putIfAbsent(folder.toLowerCase(Locale.ROOT), name);
            if (folder.isEmpty() || name.length() > LONGEST) {
                wrong.add(file + ":" + number + ": \"" + name + "\" is not a name, legal: 1 to " + LONGEST
                    + " characters with a letter or digit");
            } else if (other != null) {
                wrong.add(file + ":" + number + ": \"" + name + "\" has the same folder as \"" + other + "\", " + folder
                    + ": change one of them");
            }
            folders.put(name, folder);
        }
        if (folders.isEmpty()) {
            wrong.add(file + " has no names: write one per line");
        }
        if (!wrong.isEmpty()) {
            throw new IllegalArgumentException(String.join("\n", wrong));
        }
        return folders;
    }

    /** Returns a name that is legal on every disk and can't leave the parent folder. */
    private static String folder(String name) {
        return name.replaceAll("[^\\p{L}\\p{M}\\p{N}_]+", "-").replaceAll("^-+|-+$", "");
    }
}
