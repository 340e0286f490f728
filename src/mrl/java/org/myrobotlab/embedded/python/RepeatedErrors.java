// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Counts errors of callbacks, so that a repeated error is reported once and does not hide others. Any thread. */
public final class RepeatedErrors {
    /** Number of different errors that are counted; further ones count as new each time. */
    private static final int MOST = 1000;

    private static final String PLACE = "  File ";

    private final Map<String, Integer> counts = new LinkedHashMap<>();

    /** Returns whether this error is new. */
    public synchronized boolean isNew(String traceback) {
        if (counts.size() >= MOST && !counts.containsKey(traceback)) {
            return true;
        }
        return counts.merge(traceback, 1, Integer::sum) == 1;
    }

    /** Returns the innermost place and the message of the traceback. */
    private static String shortened(String traceback) {
        String[] lines = traceback.split("\n");
        int place = -1;
        for (int i = 0; i < lines.length; i++) {
            place = lines[i].startsWith(PLACE) ? i : place;
        }
        int from = place;
        return IntStream.range(0, lines.length).filter(i -> i == from || i > from && !lines[i].startsWith("    "))
            .mapToObj(i -> lines[i]).collect(Collectors.joining("\n"));
    }

    /** Returns a sentence for each repeated error, and forgets all errors. */
    public synchronized List<String> take() {
        List<String> sentences = new ArrayList<>();
        counts.forEach((traceback, count) -> {
            if (count > 1) {
                sentences.add("this error occurred " + count + " times:\n" + shortened(traceback));
            }
        });
        counts.clear();
        return sentences;
    }
}
