// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;

/** Packages of the panels' JavaScript and the modules that each may import, like RoomsTest for Java packages. */
public class ModulesTest {
    /** Each package with the packages that it may import besides itself. */
    private static final Map<String, Set<String>> ROOMS = Map.of("shared", Set.of(), "world", Set.of("shared"), "scene",
        Set.of("world", "shared"), "build", Set.of("world", "shared"), "records", Set.of("shared"),
        "run", Set.of("build", "records", "scene", "world", "shared"), "lidar", Set.of("shared"), "gps",
            Set.of("shared"));
    /** Package of third-party modules that the build adds, see {@code gradle/resources.gradle}. */
    private static final String LIBRARIES = "lib";
    private static final int MOST_FILES = 30;
    private static final int MOST_COLUMNS = 150;
    private static final Pattern IMPORT = Pattern.compile("(?m)^(?:import|export)\\b[^'=\\n]*'([^']+)'$");
    private static final Pattern ANY_IMPORT = Pattern.compile("(?m)^import\\b|\\bimport\\(|^export\\b.*\\bfrom\\b");
    private static final Path SERVICE = Paths.get(System.getProperty("sear.root", "."),
        "resources/resource/WebGui/app/service");
    private static final Path MODULES = SERVICE.resolve("js/sear");

    @Test
    public void aPackageImportsOnlyFromPackagesBelowIt() throws IOException {
        List<String> wrong = new ArrayList<>();
        Set<String> seen = new HashSet<>();
        imports().forEach((file, imported) -> {
            String from = room(file);
            seen.add(from);
            assertTrue(file + " lies in no room of the list " + ROOMS.keySet(), ROOMS.containsKey(from));
            imported.stream().filter(other -> !room(other).equals(from) && !ROOMS.get(from).contains(room(other)))
                .forEach(other -> wrong.add(MODULES.relativize(file) + " imports " + MODULES.relativize(other)));
        });
        assertEquals(Collections.emptyList(), wrong);
        assertEquals(ROOMS.keySet(), seen);
    }

    @Test
    public void noModuleImportsItselfThroughOthers() throws IOException {
        assertEquals("", knot(imports()));
    }

    @Test
    public void aCycleIsFound() {
        Path a = Paths.get("a.js");
        Path b = Paths.get("b.js");
        Path c = Paths.get("c.js");
        assertEquals("", knot(Map.of(a, List.of(b, c), b, List.of(c), c, List.of())));
        assertFalse(knot(Map.of(a, List.of(b), b, List.of(c), c, List.of(a))).isEmpty());
    }

    @Test
    public void modulesShareOnlyTheirExports() throws IOException {
        for (Path file : imports().keySet()) {
            assertFalse(file.toString(), Pattern.compile("window\\.\\w+(\\.\\w+)* = ")
                .matcher(Files.readString(file)).find());
        }
    }

    @Test
    public void aPackageHasThirtyFilesAtMost() throws IOException {
        imports().keySet().stream().collect(Collectors.groupingBy(ModulesTest::room, Collectors.counting()))
            .forEach((room, count) -> assertTrue(room + " has " + count + " files, legal: " + MOST_FILES,
                count <= MOST_FILES));
    }

    @Test
    public void linesHaveAsManyColumnsAsInJava() throws IOException {
        List<String> wrong = new ArrayList<>();
        try (Stream<Path> files = Files.walk(SERVICE.resolve("js"))) {
            for (Path file : files.filter(path -> path.toString().matches(".*\\.(js|css)"))
                .collect(Collectors.toList())) {
                Files.readAllLines(file).stream().filter(line -> line.length() > MOST_COLUMNS)
                    .forEach(line -> wrong.add(file + ": " + line.trim()));
            }
        }
        assertEquals(Collections.emptyList(), wrong);
    }

    /** Returns each module with its imports. */
    private static Map<Path, List<Path>> imports() throws IOException {
        Map<Path, List<Path>> all = new TreeMap<>();
        try (Stream<Path> files = Files.walk(MODULES)) {
            for (Path file : files.filter(path -> path.toString().endsWith(".js")).collect(Collectors.toList())) {
                String text = Files.readString(file);
                List<Path> imported = new ArrayList<>();
                long count = ANY_IMPORT.matcher(text).results().count();
                Matcher matcher = IMPORT.matcher(text);
                while (matcher.find()) {
                    Path other = file.resolveSibling(matcher.group(1)).normalize();
                    if (room(other).equals(LIBRARIES)) {
                        String name = "/resource/WebGui/app/service/js/sear/lib/" + other.getFileName();
                        assertNotNull(file + " imports " + name + ", which the build does not bring along",
                            ModulesTest.class.getResource(name));
                        count--;
                        continue;
                    }
                    assertTrue(file + " imports " + matcher.group(1) + ", which is not there",
                        Files.isRegularFile(other));
                    imported.add(other);
                }
                assertEquals("imports that this test does not read in " + file, count, imported.size());
                all.put(file, imported);
            }
        }
        return all;
    }

    private static String room(Path module) {
        return module.getParent().getFileName().toString();
    }

    /** Returns a cycle of imports as text, or an empty text. */
    private static String knot(Map<Path, List<Path>> imports) {
        for (Path start : imports.keySet()) {
            Set<Path> reached = new HashSet<>();
            List<Path> open = new ArrayList<>(imports.get(start));
            while (!open.isEmpty()) {
                Path module = open.remove(0);
                if (module.equals(start)) {
                    return start + " reaches itself";
                }
                if (reached.add(module)) {
                    open.addAll(imports.get(module));
                }
            }
        }
        return "";
    }
}
