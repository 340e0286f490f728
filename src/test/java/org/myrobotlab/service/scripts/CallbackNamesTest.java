// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Before;
import org.junit.Test;

/**
 * MyRobotLab ties the name of a Python callback to its first publisher, across all scripts of a session. Each callback
 * in text that users may copy therefore has a unique name.
 */
public class CallbackNamesTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."));
    private static final Pattern LISTENER =
        Pattern.compile("(\\w+)\\.addListener\\([\"'](\\w+)[\"'],\\s*[^,]+,\\s*[\"'](\\w+)[\"']");
    private static final Pattern ANY_LISTENER = Pattern.compile("\\.addListener\\(|(?<!msg)\\.subscribe\\(");
    private static final Pattern SERVICE =
        Pattern.compile("(\\w+) = Runtime\\.(?:start|createAndStart)\\(\"([^\"]+)\"");
    private static final Pattern CODE_BLOCK = Pattern.compile("```python\n(.*?)```", Pattern.DOTALL);
    private static final Pattern JAVADOC = Pattern.compile("<pre>\n(.*?)</pre>", Pattern.DOTALL);
    /** Listings printed with the callback {@code input} in the dissertation. */
    private static final List<String> PRINTED_WITH_INPUT =
        Arrays.asList("scripts/listing05.py", "scripts/listing06.py");

    /** All code that adds listeners or may do so, by file. */
    private final Map<String, String> code = new TreeMap<>();
    private final List<Listener> listeners = new ArrayList<>();

    /** One call of addListener. */
    private static final class Listener {
        private final String file;
        private final String publisher;
        private final String callback;

        Listener(String file, String publisher, String callback) {
            this.file = file;
            this.publisher = publisher;
            this.callback = callback;
        }

        @Override
        public String toString() {
            return file + ": " + publisher + " calls " + callback;
        }
    }

    @Before
    public void collect() throws IOException {
        for (String folder : new String[] {"scripts", "examples", "resources"}) {
            add(folder, ".py", Pattern.compile("(.*)", Pattern.DOTALL));
        }
        add("docs", ".md", CODE_BLOCK);
        add("README.md", ".md", CODE_BLOCK);
        add("src/main/java/org/myrobotlab", ".java", JAVADOC);
        code.forEach(this::addListeners);
    }

    private void add(String where, String ending, Pattern part) throws IOException {
        try (Stream<Path> files = Files.walk(ROOT.resolve(where))) {
            for (Path file : files.filter(each -> each.toString().endsWith(ending)).collect(Collectors.toList())) {
                String parts = part.matcher(Files.readString(file)).results().map(found -> found.group(1))
                    .collect(Collectors.joining("\n"));
                code.put(ROOT.relativize(file).toString().replace('\\', '/'),
                    parts.replaceAll("(?m)(?<!['\"])#.*$", ""));
            }
        }
    }

    private void addListeners(String file, String text) {
        Matcher call = LISTENER.matcher(text);
        while (call.find()) {
            listeners.add(new Listener(file, serviceOf(call.group(1), text.substring(0, call.start())) + "."
                + call.group(2), call.group(3)));
        }
    }

    /** Returns the service that a variable holds. */
    private static String serviceOf(String variable, String before) {
        String service = variable;
        Matcher start = SERVICE.matcher(before);
        while (start.find()) {
            service = start.group(1).equals(variable) ? start.group(2) : service;
        }
        return service;
    }

    @Test
    public void everyListenerIsSeen() {
        long calls = code.values().stream().flatMap(text -> ANY_LISTENER.matcher(text).results()).count();
        assertEquals(listeners.toString(), calls, listeners.size());
        for (String file : new String[] {"README.md", "docs/scripting.md", "scripts/demo.py", "scripts/listing08.py",
            "scripts/listing10.py",
            "resources/templates/controller.py", "resources/templates/userCode.py", "resources/resource/LIDAR/LIDAR.py",
            "resources/resource/GPS/GPS.py", "src/main/java/org/myrobotlab/service/LIDAR.java"}) {
            assertTrue(file + " is not in " + listeners, listeners.stream().anyMatch(one -> one.file.equals(file)));
        }
    }

    @Test
    public void noTwoListenersShareACallback() {
        List<String> shared = new ArrayList<>();
        for (Listener one : listeners) {
            listeners.stream().filter(other -> other != one && other.callback.equals(one.callback)
                && !isPrinted(one, other)).forEach(other -> shared.add(one + ", and " + other));
        }
        assertEquals("[]", shared.toString());
    }

    /** Harmless if the publisher is the same, and required: two names on one service would both be called. */
    private static boolean isPrinted(Listener one, Listener other) {
        return one.callback.equals("input") && PRINTED_WITH_INPUT.containsAll(Arrays.asList(one.file, other.file))
            && one.publisher.equals(other.publisher);
    }

    /** A listener outlives its script: the next script's listener for the same service does not replace it. */
    @Test
    public void noPublisherCallsTwo() {
        List<String> twice = new ArrayList<>();
        for (Listener one : listeners) {
            listeners.stream().filter(other -> other.publisher.equals(one.publisher)
                && !other.callback.equals(one.callback)).forEach(other -> twice.add(one + ", and " + other));
        }
        assertEquals("[]", twice.toString());
    }

    /** An earlier listener would call the next script's function of that name. */
    @Test
    public void callbackNamesAreUnique() {
        List<String> taken = new ArrayList<>();
        for (Listener one : listeners) {
            Pattern own = Pattern.compile("(?m)^\\s*((def|class)\\s+NAME\\b|NAME\\s*=)|\\bas NAME\\b"
                .replace("NAME", one.callback));
            code.forEach((file, text) -> {
                boolean printed = one.callback.equals("input") && PRINTED_WITH_INPUT.contains(file);
                if (!file.equals(one.file) && !printed && own.matcher(text).find()) {
                    taken.add(file + " has a " + one.callback + " of its own, which is the callback of " + one.file);
                }
            });
        }
        assertEquals("[]", taken.toString());
    }

    @Test
    public void listingsThatUseInputStateItInTheirFirstLines() throws IOException {
        for (String file : PRINTED_WITH_INPUT) {
            String head = Files.readAllLines(ROOT.resolve(file)).stream().takeWhile(line -> line.startsWith("#"))
                .collect(Collectors.joining(" "));
            assertTrue(head, head.contains("keeps its name input"));
        }
        assertEquals(PRINTED_WITH_INPUT, listeners.stream().filter(one -> one.callback.equals("input"))
            .map(one -> one.file).distinct().collect(Collectors.toList()));
    }
}
