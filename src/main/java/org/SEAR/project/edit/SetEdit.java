// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.project.problems.ProjectException;

/** Sets parameters: {@code object}, {@code set} parameters, {@code was} the values that the client has read. */
final class SetEdit extends Edit {
    @Override
    EditResult apply() throws IOException, ProjectException {
        ObjectLocation place = finder.find(request.text("object"));
        return finish(place, words(request.values("set")) + place.object.getName());
    }

    private static String words(Map<?, ?> values) {
        String names = values.keySet().stream().map(String::valueOf).sorted().collect(Collectors.joining(", "));
        return names.matches("[xyz, ]+") ? "move " : names.matches("(r[xyz]|, )+") ? "turn " : "change "
            + names + " of ";
    }
}
