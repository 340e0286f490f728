package org.myrobotlab.embedded.python;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Counts errors of callbacks, so that one that comes with each scan is told once and hides nothing else. Any thread. */
public final class RepeatedErrors {
    /** Errors that are known; more are told each time. */
    private static final int MOST = 1000;

    private final Map<String, Integer> counts = new LinkedHashMap<>();

    /** Whether an error has not come before. */
    public synchronized boolean isNew(String traceback) {
        if (counts.size() >= MOST && !counts.containsKey(traceback)) {
            return true;
        }
        return counts.merge(traceback, 1, Integer::sum) == 1;
    }

    /** What came more than once, a sentence each; forgets all errors. */
    public synchronized List<String> take() {
        List<String> sentences = new ArrayList<>();
        counts.forEach((traceback, count) -> {
            if (count > 1) {
                sentences.add("this error came " + count + " times:\n" + traceback);
            }
        });
        counts.clear();
        return sentences;
    }
}
