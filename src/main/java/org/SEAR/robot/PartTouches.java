// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** Parts of one robot's body that touch an object now. A sleeping body keeps its last contacts. Simulation thread. */
final class PartTouches {
    private final Map<String, Integer> solids = new HashMap<>();
    private final boolean[] touched;
    private final int wheelsFrom;
    private boolean any;

    PartTouches(RobotBuilder from) {
        from.object.getComponents().stream().filter(from.shapes::containsKey)
            .forEach(part -> solids.put(part.getName(), from.solidOf(part)));
        touched = new boolean[from.body.solids.size()];
        wheelsFrom = touched.length - from.wheelSolids.size();
    }

    void clear() {
        Arrays.fill(touched, false);
        any = false;
    }

    /** Whether a solid belongs to a wheel. */
    boolean isWheel(int solid) {
        return solid >= wheelsFrom;
    }

    /** @param solid its index in the body */
    void add(int solid) {
        touched[solid] = true;
        any = true;
    }

    /** @param part name of a component; null for any part, wheels included */
    boolean is(String part) {
        Integer solid = part == null ? null : solids.get(part);
        return part == null ? any : solid != null && touched[solid];
    }
}
