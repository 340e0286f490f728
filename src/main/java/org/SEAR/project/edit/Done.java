package org.SEAR.project.edit;

import java.util.List;
import java.util.stream.Collectors;

/** What an edit has done. Immutable, any thread. */
final class Done {
    private static final int MOST_TOLD = 5;

    /** As in "undo: move crate". */
    final String words;
    /** What edits call its object from then on; null if that is gone. */
    final String object;
    /** What has become of other objects by it, as "motor left was deleted with wheel leftWheel". */
    final List<String> besides;

    Done(String words, String object) {
        this(words, object, List.of());
    }

    Done(String words, String object, List<String> besides) {
        this.words = words;
        this.object = object;
        this.besides = List.copyOf(besides);
    }

    /** What has become of other objects, in one line; null if nothing. */
    String note() {
        if (besides.isEmpty()) {
            return null;
        }
        String told = besides.stream().limit(MOST_TOLD).collect(Collectors.joining("; "));
        int more = besides.size() - MOST_TOLD;
        return told + (more > 0 ? "; and " + more + " more" : "") + "; Undo brings back " + (besides.size() == 1 ? "both" : "all of it");
    }
}
