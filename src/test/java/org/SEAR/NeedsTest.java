// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;

/** A test class that uses what a Gradle task makes or fetches names that task in {@link Needs}. */
public class NeedsTest {
    private static final Path TESTS = Path.of(System.getProperty("sear.root", "."), "src/test/java");
    private static final Pattern NEEDS = Pattern.compile("(?m)^@Needs\\(([^)]*)\\)");
    private static final Pattern PROPERTY = Pattern.compile("getProperty\\(\"sear\\.(\\w+(?:\\.built)?)\"");
    /** Each system property that {@code gradle/tests.gradle} sets, with the task that makes its file or folder. */
    private static final Map<String, String> TASKS =
        new TreeMap<>(Map.of("zip", "distZip", "jmhClasspath", "jmhClasses", "classArchive",
        "classArchive", "home.built", "installDist"));

    static {
        List.of("drivers", "johnnyFive", "rasterio", "pyproj", "kissIcp", "opencv", "python3", "numpy1",
            "gymnasium", "sweep", "jupyter").forEach(fetched -> TASKS.put(fetched, fetched));
    }

    @Test
    public void eachTestClassNamesTheTasksWhoseFilesItUses() throws IOException {
        List<String> wrong = new ArrayList<>();
        int classes = 0;
        for (Path file : tests()) {
            String text = Files.readString(file);
            Matcher needs = NEEDS.matcher(text);
            String named = needs.find() ? needs.group(1) : "";
            classes += named.isEmpty() ? 0 : 1;
            PROPERTY.matcher(text).results().map(found -> TASKS.get(found.group(1)))
                .filter(task -> task != null && !named.contains('"' + task + '"'))
                .forEach(task -> wrong.add(file.getFileName() + " lacks @Needs(\"" + task + "\")"));
        }
        assertEquals(List.of(), wrong);
        assertTrue(classes + " classes", classes > 10);
    }

    private static List<Path> tests() throws IOException {
        try (Stream<Path> files = Files.walk(TESTS)) {
            return files.filter(file -> file.toString().endsWith("Test.java")).sorted().collect(Collectors.toList());
        }
    }
}
