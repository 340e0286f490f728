package org.SEAR.cli.install;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/** What a library's file name says of it. Immutable. */
final class JarName {
    private static final Pattern PARTS = Pattern.compile("(.*?)(?:-(\\d.*?))?(-natives-.*)?\\.jar");
    private static final Pattern BETWEEN_NUMBERS = Pattern.compile("[.-]");
    private static final int NUMBERS = 8;
    /** What the window needs, by the first word of the name: jMonkeyEngine, and LWJGL below it, which belongs to it. */
    private static final Map<String, String> WINDOW_NEEDS = Map.of("jme3", "3.6", "lwjgl", "3.3");
    /** Optional reader of models; there is no newer one. */
    private static final String BLENDER = "jme3-blender";

    /** The file's name. */
    final String name;
    /** {@code jme3-core} of {@code jme3-core-3.6.1-stable.jar}; a natives classifier belongs to it. */
    final String artifact;
    /** {@code 3.6.1-stable} of {@code jme3-core-3.6.1-stable.jar}; empty where the name has none. */
    final String version;

    JarName(Path jar) {
        name = jar.getFileName().toString();
        Matcher parts = PARTS.matcher(name);
        if (!parts.matches()) {
            throw new IllegalArgumentException(name + " is not the name of a jar");
        }
        artifact = parts.group(1) + (parts.group(3) == null ? "" : parts.group(3));
        version = parts.group(2) == null ? "" : parts.group(2);
    }

    /** The lowest version that the window works with, null for a library that it does not need. */
    String neededVersion() {
        return artifact.equals(BLENDER) ? null : WINDOW_NEEDS.get(artifact.replaceAll("-.*", ""));
    }

    boolean isTooOldForTheWindow() {
        return neededVersion() != null && compare(version, neededVersion()) < 0;
    }

    /** Compares versions number by number; what is not a number counts as 0. */
    static int compare(String a, String b) {
        return Arrays.compare(numbers(a), numbers(b));
    }

    private static int[] numbers(String version) {
        IntStream numbers = BETWEEN_NUMBERS.splitAsStream(version).mapToInt(part -> part.matches("\\d{1,9}") ? Integer.parseInt(part) : 0);
        return IntStream.concat(numbers, IntStream.generate(() -> 0)).limit(NUMBERS).toArray();
    }
}
