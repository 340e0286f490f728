// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.project.problems.ProjectException;

/** Several edits as one step: {@code edits}, {@code words} their description. */
final class GroupEdit extends Edit {
    private static final int MAX_EDITS = 1000;

    @Override
    EditResult apply() throws IOException, ProjectException {
        List<Map<?, ?>> edits = request.list("edits");
        if (edits.isEmpty() || edits.size() > MAX_EDITS || edits.stream()
            .anyMatch(one -> "all".equals(one.get("do")))) {
            throw EditRequest.refused("edits", edits.size() + " edits", "1 to " + MAX_EDITS
                + " edits, none of them of this kind");
        }
        EditResult last = null;
        List<String> besides = new ArrayList<>();
        for (Map<?, ?> one : edits) {
            last = ProjectEditor.perform(draft, new EditRequest(one));
            besides.addAll(last.besides);
        }
        String words = request.textOrNull("words");
        return new EditResult(words == null ? last.words + (edits.size() > 1 ? " and " + (edits.size() - 1) + " more"
            : "") : words, last.object, besides);
    }
}
