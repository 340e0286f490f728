// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Name and version of a library, from its file name. Immutable. */
final class JarName {
    private static final Pattern PARTS = Pattern.compile("(.*?)(?:-(\\d.*?))?(-natives-.*)?\\.jar");
    private static final int NUMBERS = 8;
    /** Lowest versions for the window by the first word of the name: jMonkeyEngine and its LWJGL. */
    private static final Map<String, String> WINDOW_NEEDS = Map.of("jme3", "3.6", "lwjgl", "3.3");
    /** Optional model loader; has no newer version. */
    private static final String BLENDER = "jme3-blender";
    /** Older versions that are known to work, as in MyRobotLab's develop branch of 2024. */
    private static final Map<String, String> WORKS_FROM = Map.of("xstream", "1.4.19");

    /** File name. */
    final String name;
    /** {@code jme3-core} of {@code jme3-core-3.6.1-stable.jar}; includes a natives classifier. */
    final String artifact;
    /** {@code 3.6.1-stable} of {@code jme3-core-3.6.1-stable.jar}; empty without a version. */
    final String version;
    /** Lowest version for the window; null for a library that it does not need. */
    private final String needed;

    JarName(Path jar) {
        name = jar.getFileName().toString();
        Matcher parts = PARTS.matcher(name);
        if (!parts.matches()) {
            throw new IllegalArgumentException(name + " is not the name of a jar");
        }
        artifact = parts.group(1) + (parts.group(3) == null ? "" : parts.group(3));
        version = parts.group(2) == null ? "" : parts.group(2);
        needed = artifact.equals(BLENDER) ? null : WINDOW_NEEDS.get(artifact.replaceAll("-.*", ""));
    }

    boolean isTooOldForTheWindow() {
        return needed != null && compare(version, needed) < 0;
    }

    /** Returns how well this library replaces SEAR's own. */
    String verdict(JarName ours) {
        if (isTooOldForTheWindow()) {
            return "the window needs " + needed + "; --replace-jme replaces it";
        }
        String enough = WORKS_FROM.getOrDefault(artifact, needed);
        if (enough != null && compare(version, enough) >= 0) {
            return "works";
        }
        return compare(version, ours.version) > 0 ? "newer, should work" : "older, not tested with SEAR";
    }

    /** Compares versions number by number; parts that are not numbers count as 0. */
    static int compare(String a, String b) {
        return Arrays.compare(numbers(a), numbers(b));
    }

    private static int[] numbers(String version) {
        IntStream numbers = Stream.of(version.split("[.-]"))
            .mapToInt(part -> part.matches("\\d{1,9}") ? Integer.parseInt(part) : 0);
        return IntStream.concat(numbers, IntStream.generate(() -> 0)).limit(NUMBERS).toArray();
    }
}
