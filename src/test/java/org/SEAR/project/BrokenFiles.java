package org.SEAR.project;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * A file of a project that is broken in one way, with the message for it. All stand in one table, {@code broken-files.txt}: a block starts with
 * {@code # file}, then comes the file's text, then a line {@code =>} for each problem, in order.
 */
public final class BrokenFiles {
    /** What is well in a project that the broken file is put into. */
    public static final Map<String, String> GOOD = Map.of("robot/r.xml", "<SEARrobot><name>r</name><component>d</component></SEARrobot>",
        "robot/d.xml", "<Dynamics><name>d</name><mass>3</mass></Dynamics>",
        "environment/other.xml", "<Box><name>other</name><length>1</length><width>1</width><height>1</height></Box>");

    /** Its path in the project. */
    public final String file;
    /** Its text. */
    public final StringBuilder text = new StringBuilder();
    /** The problems; the end of one may be left out, for which stands "...". */
    public final List<String> messages = new ArrayList<>();

    private BrokenFiles(String file) {
        this.file = file;
    }

    /** The whole table. */
    public static List<BrokenFiles> all() throws IOException {
        List<BrokenFiles> cases = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(new InputStreamReader(BrokenFiles.class.getResourceAsStream("broken-files.txt"),
                StandardCharsets.UTF_8))) {
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                if (line.startsWith("# ")) {
                    cases.add(new BrokenFiles(line.substring(2)));
                } else if (line.startsWith("=> ")) {
                    cases.get(cases.size() - 1).messages.add(line.substring(3));
                } else if (!line.isEmpty()) {
                    cases.get(cases.size() - 1).text.append(line).append('\n');
                }
            }
        }
        return cases;
    }

    /** Whether these are the problems, and no others. */
    public boolean matches(List<String> found) {
        boolean same = messages.size() == found.size();
        for (int i = 0; same && i < messages.size(); i++) {
            same = messages.get(i).endsWith("...") ? found.get(i).startsWith(beginning(i)) : found.get(i).equals(messages.get(i));
        }
        return same;
    }

    /** A message without what is left out of it. */
    public String beginning(int message) {
        String text = messages.get(message);
        return text.endsWith("...") ? text.substring(0, text.length() - 3) : text;
    }
}
