package org.SEAR.cli.lessons;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** What a script's error says, in one line. Immutable, any thread. */
public final class ErrorWords {
    private static final int LONGEST = 400;

    /** The last line of the script that took part; empty if none is known. */
    public final String line;
    /** What went wrong, with hints behind it; empty if nothing was said. */
    public final String words;

    /**
     * Of what was printed.
     *
     * @param script the name of its file
     */
    public ErrorWords(String traceback, String script) {
        Matcher places = Pattern.compile("File \"[^\"\\n]*" + Pattern.quote(script) + "\", line (\\d+)").matcher(traceback);
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
