// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.problems.ProjectException;

/** Deletes an {@code object}; a robot with all of its parts, a part with the parts that need it. */
final class DeleteEdit extends Edit {
    @Override
    EditResult apply() throws IOException, ProjectException {
        ObjectLocation place = finder.find(request.text("object"));
        References others = leave(place);
        if (place.object instanceof SEARrobot) {
            ((SEARrobot) place.object).getComponentNames().forEach(file -> draft.delete(ObjectFiles.path(true, file)));
        }
        int also = others.deleted().size();
        String with = also == 0 ? "" : " with " + (also == 1 ? References.called(others.deleted().get(0))
            : also + " more");
        return new EditResult("delete " + place.object.getName() + with, null,
            besides(others, place, " was deleted with "));
    }
}
