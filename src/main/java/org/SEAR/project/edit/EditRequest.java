// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;

/** An edit as a page or script sends it. Immutable as long as the map is not changed, any thread. */
final class EditRequest {
    private final Map<?, ?> map;

    EditRequest(Map<?, ?> map) {
        this.map = map;
    }

    /**
     * Returns a required text.
     *
     * @throws ProjectException if it is missing
     */
    String text(String key) throws ProjectException {
        String text = textOrNull(key);
        if (text == null || text.isEmpty()) {
            throw refused(key, "", "a text; this edit needs it");
        }
        return text;
    }

    /** Returns a text; null if it is missing. */
    String textOrNull(String key) {
        Object value = map.get(key);
        return value == null ? null : value.toString();
    }

    /**
     * Returns values by their names.
     *
     * @return empty if they are missing
     * @throws ProjectException if the entry is of another kind
     */
    Map<?, ?> values(String key) throws ProjectException {
        Object value = map.get(key);
        if (value == null) {
            return Collections.emptyMap();
        }
        if (!(value instanceof Map)) {
            throw refused(key, value.toString(), "names of parameters with their values");
        }
        return (Map<?, ?>) value;
    }

    /**
     * Returns a list of requests.
     *
     * @throws ProjectException if an entry is of another kind
     */
    List<Map<?, ?>> list(String key) throws ProjectException {
        List<Map<?, ?>> all = new ArrayList<>();
        Object value = map.get(key);
        for (Object one : value instanceof List ? (List<?>) value : List.of()) {
            if (!(one instanceof Map)) {
                throw refused(key, String.valueOf(one), "a list of edits");
            }
            all.add((Map<?, ?>) one);
        }
        return all;
    }

    static ProjectException refused(String key, String value, String legal) {
        return new ProjectException(List.of(new Problem("edit", 0, key, value, legal)));
    }
}
