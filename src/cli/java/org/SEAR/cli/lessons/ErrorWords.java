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
