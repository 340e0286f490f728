// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The calls of scripts, as in docs/scripting.md, for completion in editors. Any thread. */
public final class ScriptCalls {
    private static final String LIST = "/org/SEAR/script-calls.txt";
    private static final int COLUMNS = 4;

    private ScriptCalls() {
    }

    /**
     * Returns {@code {"type": "SEAR", "name": "simSleep", "parameters": "seconds", "doc": ..}}, in the order of the
     * page.
     */
    public static List<Map<String, String>> list() throws IOException {
        List<Map<String, String>> calls = new ArrayList<>();
        try (InputStream in = ScriptCalls.class.getResourceAsStream(LIST)) {
            for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n")) {
                String[] parts = line.split("\t", COLUMNS);
                calls.add(Map.of("type", parts[0], "name", parts[1], "parameters", parts[2], "doc",
                    parts[COLUMNS - 1]));
            }
        }
        return calls;
    }
}
