// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * A project file with one error, and its messages. All cases are in one table, {@code broken-files.txt}: a block starts
 * with {@code # file}, then the file's text, then a line {@code =>} per problem, in order.
 */
public final class BrokenFiles {
    /** Valid files of the project around the broken file. */
    public static final Map<String, String> GOOD =
        Map.of("robot/r.xml", "<SEARrobot><name>r</name><component>d</component></SEARrobot>",
        "robot/d.xml", "<Dynamics><name>d</name><mass>3</mass></Dynamics>",
        "environment/other.xml", "<Box><name>other</name><length>1</length><width>1</width><height>1</height></Box>");

    /** Path of the file in the project. */
    public final String file;
    public final StringBuilder text = new StringBuilder();
    /** Expected problems; "..." replaces the end of a long one. */
    public final List<String> messages = new ArrayList<>();

    private BrokenFiles(String file) {
        this.file = file;
    }

    public static List<BrokenFiles> all() throws IOException {
        List<BrokenFiles> cases = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(
            new InputStreamReader(BrokenFiles.class.getResourceAsStream("broken-files.txt"), StandardCharsets.UTF_8))) {
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

    /** Returns whether exactly these problems were found. */
    public boolean matches(List<String> found) {
        boolean same = messages.size() == found.size();
        for (int i = 0; same && i < messages.size(); i++) {
            same = messages.get(i).endsWith("...") ? found.get(i).startsWith(beginning(i)) : found.get(i)
                .equals(messages.get(i));
        }
        return same;
    }

    /** Returns a message without its ending "...". */
    public String beginning(int message) {
        String text = messages.get(message);
        return text.endsWith("...") ? text.substring(0, text.length() - 3) : text;
    }
}
