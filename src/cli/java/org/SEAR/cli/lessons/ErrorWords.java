// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** A script's error in one line. Immutable, any thread. */
public final class ErrorWords {
    private static final int LONGEST = 400;

    /** Line number of the script's innermost frame; empty if unknown. */
    public final String line;
    /** The error with its hints; empty without one. */
    public final String words;

    /** Calls that replace the project, or give it other objects. */
    private static final Pattern OTHER_WORLD = Pattern.compile(
        "\\b(newProject|loadProject|import(Robot|Environment)|Floor|Box|Cylinder|Sphere|Robots\\.\\w+|SEARrobot)"
            + "\\s*\\(");

    /**
     * Explains a run that the lesson's world does not give.
     *
     * @param script name of the script's file
     * @param text the script
     * @param reason for the teacher
     */
    static String otherWorld(String script, String text, String reason) {
        List<String> lines = text.lines().map(line -> line.replaceAll("#.*", "")).collect(Collectors.toList());
        for (int i = 0; i < lines.size(); i++) {
            Matcher call = OTHER_WORLD.matcher(lines.get(i));
            if (call.find()) {
                return "Line " + (i + 1) + " of " + script + " replaces or changes the lesson's world (" + call.group(1)
                    + "): the world is there already. Delete all lines that make objects, and only start and drive.";
            }
        }
        return "Your script's run can't be marked: it must use the lesson's world unchanged. (" + reason + ")";
    }

    /**
     * Reads a traceback.
     *
     * @param script name of the script's file
     */
    public ErrorWords(String traceback, String script) {
        Matcher places = Pattern.compile("File \"[^\"\\n]*" + Pattern.quote(script) + "\", line (\\d+)")
            .matcher(traceback);
        String last = "";
        while (places.find()) {
            last = places.group(1);
        }
        line = last;
        List<String> lines = traceback.lines().filter(one -> !one.isBlank()).collect(Collectors.toList());
        int from = Math.max(0, lines.size() - 1);
        for (int i = lines.size() - 1; i >= 0 && !lines.get(i).startsWith("  File "); i--) {
            from = lines.get(i).startsWith(" ") ? from : i;
        }
        String said = lines.subList(from, lines.size()).stream().map(String::trim).collect(Collectors.joining(", "));
        words = said.length() > LONGEST ? said.substring(0, LONGEST) : said;
    }
}
