// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Generates {@code docs/scripting.md}: every call of SEAR, LIDAR and GPS for scripts, from their javadoc.
 * {@code gradle scriptDocs} writes it.
 */
public final class ScriptDocs {
    static final List<String> SERVICES = Arrays.asList("SEAR", "LIDAR", "GPS");
    /** Preparation that all examples assume. */
    static final String PREPARATION = "sear = Runtime.start(\"sear\", \"SEAR\")\n"
        + "lidar = Runtime.start(\"guideLidar\", \"LIDAR\")     # the driver of a SICK LMS200, real or simulated\n"
        + "gps = Runtime.start(\"guideGps\", \"GPS\")           # the driver of a GPS receiver, real or simulated\n"
        + "sear.loadProject(\"examples/sensors.sear\")\nsear.startSimulation()\n";
    private static final String PANELS = "for panels";
    private static final String MYROBOTLAB = "MyRobotLab";

    private final Map<String, JavadocReader> services = new LinkedHashMap<>();

    /** @param root of the sources */
    ScriptDocs(Path root) throws IOException {
        for (String service : SERVICES) {
            services.put(service, new JavadocReader(
                root.resolve("src/main/java/org/myrobotlab/service/" + service + ".java")));
        }
    }

    /**
     * Writes the page and its picture.
     * @param args the page, the picture
     */
    public static void main(String[] args) throws IOException {
        Files.write(Path.of(args[0]), new ScriptDocs(Path.of(".")).page().getBytes(StandardCharsets.UTF_8));
        Files.write(Path.of(args[1]), FramesPicture.svg().getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the methods for scripts in the order of the page. */
    List<ScriptCall> calls(String service) {
        return services.get(service).calls().stream()
            .filter(call -> !call.overrides && !call.section.equals(PANELS) && !call.section.equals(MYROBOTLAB))
            .collect(Collectors.toList());
    }

    /** Returns the purpose of a service. */
    String about(String service) {
        return services.get(service).about();
    }

    /** Returns the missing parts of the javadoc. */
    List<String> gaps() {
        List<String> gaps = new ArrayList<>();
        SERVICES.forEach(service -> calls(service)
            .forEach(call -> call.gaps().forEach(gap -> gaps.add(service + "." + gap))));
        return gaps;
    }

    /** Returns the page in Markdown. */
    String page() throws IOException {
        List<String> gaps = gaps();
        if (!gaps.isEmpty()) {
            throw new IOException("the javadoc of the services has gaps: " + gaps);
        }
        StringBuilder contents = new StringBuilder();
        StringBuilder body = new StringBuilder();
        for (String service : SERVICES) {
            Map<String, List<ScriptCall>> sections = new LinkedHashMap<>();
            calls(service).forEach(call -> sections.computeIfAbsent(call.section, any -> new ArrayList<>()).add(call));
            sections.forEach((section, calls) -> {
                String title = section.isEmpty() ? service : service + ": " + section;
                contents.append("- [").append(section.isEmpty() ? service : section).append("](#").append(anchor(title))
                    .append("): ")
                    .append(calls.stream().map(call -> call.name).distinct().collect(Collectors.joining(", ")))
                    .append('\n');
                body.append("\n## ").append(title).append('\n');
                if (section.isEmpty()) {
                    body.append('\n').append(services.get(service).about()).append('\n');
                }
                calls.forEach(call -> describe(body, call));
            });
        }
        return head().replace("CONTENTS\n", contents) + body;
    }

    private static String head() throws IOException {
        return new String(ScriptDocs.class.getResourceAsStream("scripting-head.md").readAllBytes(),
            StandardCharsets.UTF_8).replace("PREPARATION\n", PREPARATION);
    }

    /** Returns GitHub's anchor of a title. */
    private static String anchor(String title) {
        return title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9 -]", "").replace(' ', '-');
    }

    private static void describe(StringBuilder out, ScriptCall call) {
        out.append("\n### ").append(call.signature()).append("\n\n").append(call.text).append("\n");
        StringBuilder list = new StringBuilder();
        call.parameters.forEach((name, text) -> {
            if (!text.isEmpty()) {
                list.append("- `").append(name).append("`: ").append(text).append('\n');
            }
        });
        if (!call.answers.isEmpty() && !call.name.startsWith("publish")) {
            list.append("- returns ").append(call.answers).append(call.returns.isEmpty() ? "" : ": " + call.returns)
                .append('\n');
        }
        call.errors.forEach((type, text) -> list.append("- ").append(type).append(": ").append(text).append('\n'));
        if (list.length() > 0) {
            out.append('\n').append(list);
        }
        out.append("\n```python\n").append(call.example).append("\n```\n");
    }
}
