// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.SEAR;
import org.SEAR.cli.SearCommand;

/** Sizes of classes and packages stay within the guides, except those that {@code config/sizes.txt} lists. */
public class SizesTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", "."));
    private static final Path LIST = ROOT.resolve("config/sizes.txt");
    private static final List<String> SOURCES = List.of("main", "mrl", "cli", "assets", "jmh", "tools");
    private static final Map<String, Integer> GUIDES = Map.of("lines", 400, "fields", 30, "methods", 40, "files", 30);

    @Test
    public void noSizeExceedsItsGuideOrItsException() throws Exception {
        assertEquals(List.of(), complaints(measured(), Files.readAllLines(LIST)));
    }

    @Test
    public void exceptionsMayOnlyShrink() {
        List<String> list = List.of("# comment", "", "lines 410 a.A one parser");
        assertEquals(List.of(), complaints(sizes("lines a.A", 405, "lines a.B", 400), list));
        assertEquals(List.of("lines a.A: 411, legal: at most 410"), complaints(sizes("lines a.A", 411), list));
        assertEquals(List.of("lines a.A: 410, legal: at most 400, or 410 by config/sizes.txt"),
            complaints(sizes("lines a.A", 410), List.of()));
        assertEquals(List.of("lines a.A: remove it from config/sizes.txt"), complaints(sizes("lines a.A", 400), list));
        assertEquals(List.of("lines a.A: remove it from config/sizes.txt"), complaints(Map.of(), list));
        assertEquals(List.of("lines a.A: state the reason in config/sizes.txt"),
            complaints(sizes("lines a.A", 410), List.of("lines 410 a.A")));
    }

    private static Map<String, Integer> sizes(Object... pairs) {
        Map<String, Integer> sizes = new TreeMap<>();
        for (int i = 0; i < pairs.length; i += 2) {
            sizes.put((String) pairs[i], (Integer) pairs[i + 1]);
        }
        return sizes;
    }

    /**
     * Compares sizes with their guides.
     * @param measured number by kind and name, such as {@code lines a.A}
     * @param list lines of the exceptions: kind, number, name, reason
     */
    private static List<String> complaints(Map<String, Integer> measured, List<String> list) {
        Map<String, Integer> exceptions = new TreeMap<>();
        List<String> wrong = new ArrayList<>();
        for (String line : list) {
            String[] words = line.split(" ", 4);
            if (!line.isEmpty() && !line.startsWith("#")) {
                String what = words[0] + " " + words[2];
                exceptions.put(what, Integer.valueOf(words[1]));
                if (words.length < 4) {
                    wrong.add(what + ": state the reason in config/sizes.txt");
                }
            }
        }
        measured.forEach((what, size) -> {
            int guide = GUIDES.get(what.split(" ")[0]);
            Integer exception = exceptions.remove(what);
            if (exception != null && size <= guide) {
                wrong.add(what + ": remove it from config/sizes.txt");
            } else if (exception != null && size > exception) {
                wrong.add(what + ": " + size + ", legal: at most " + exception);
            } else if (exception == null && size > guide) {
                wrong.add(what + ": " + size + ", legal: at most " + guide + ", or " + size + " by config/sizes.txt");
            }
        });
        exceptions.keySet().forEach(what -> wrong.add(what + ": remove it from config/sizes.txt"));
        return wrong;
    }

    private static Map<String, Integer> measured() throws IOException, URISyntaxException {
        Map<String, Integer> sizes = new TreeMap<>();
        for (String sources : SOURCES) {
            Path root = ROOT.resolve("src").resolve(sources).resolve("java");
            Map<String, Integer> files = new TreeMap<>();
            for (Path file : files(root, ".java")) {
                sizes.put("lines " + name(root, file, ".java"), Files.readAllLines(file).size());
                files.merge("files " + name(root, file.getParent(), ""), 1, Integer::sum);
            }
            files.forEach((what, count) -> sizes.merge(what, count, Math::max));
        }
        for (Class<?> place : List.of(SEAR.class, SearCommand.class, Service.class)) {
            Path root = Path.of(place.getProtectionDomain().getCodeSource().getLocation().toURI());
            for (Path file : files(root, ".class")) {
                measure(name(root, file, ".class"), sizes);
            }
        }
        sizes.keySet().removeIf(what -> what.endsWith("package-info"));
        return sizes;
    }

    private static void measure(String name, Map<String, Integer> sizes) {
        try {
            Class<?> type = Class.forName(name, false, SizesTest.class.getClassLoader());
            sizes.put("fields " + name, (int) Arrays.stream(type.getDeclaredFields())
                .filter(SizesTest::isState).count());
            sizes.put("methods " + name, (int) Arrays.stream(type.getDeclaredMethods())
                .filter(method -> !method.isSynthetic()).count());
        } catch (ClassNotFoundException e) {
            throw new AssertionError(name, e);
        }
    }

    private static boolean isState(Field field) {
        return !field.isSynthetic() && !(Modifier.isStatic(field.getModifiers())
            && Modifier.isFinal(field.getModifiers()));
    }

    private static List<Path> files(Path root, String end) throws IOException {
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(file -> file.toString().endsWith(end)).collect(Collectors.toList());
        }
    }

    private static String name(Path root, Path file, String end) {
        String name = root.relativize(file).toString().replace(java.io.File.separatorChar, '.');
        return name.substring(0, name.length() - end.length());
    }
}
