// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.List;
import java.util.stream.Collectors;

/** Result of an edit. Immutable, any thread. */
final class EditResult {
    private static final int MAX_REPORTED = 5;

    /** Description, as in "undo: move crate". */
    final String words;
    /** Address of the edited object; null if it was deleted. */
    final String object;
    /** Effects on other objects, such as "motor left was deleted with wheel leftWheel". */
    final List<String> besides;

    EditResult(String words, String object, List<String> besides) {
        this.words = words;
        this.object = object;
        this.besides = List.copyOf(besides);
    }

    /** Returns the effects on other objects in one line; null for none. */
    String note() {
        if (besides.isEmpty()) {
            return null;
        }
        String reported = besides.stream().limit(MAX_REPORTED).collect(Collectors.joining("; "));
        int more = besides.size() - MAX_REPORTED;
        return reported + (more > 0 ? "; and " + more + " more" : "") + "; Undo brings back "
            + (besides.size() == 1 ? "both" : "all of it");
    }
}
