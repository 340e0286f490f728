// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ObjectClasses;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.project.xml.Xml;

/** Objects and robots whose pose an edit changes, and whether it changes anything else. Immutable, any thread. */
final class PoseChanges {
    private static final List<String> PLACING = List.of("x", "y", "z", "rx", "ry", "rz", "onGround", "placeLatitude",
        "placeLongitude", "placeHeading");

    /**
     * Names of environment objects and robots; for the Dynamics of robots, the component's name in the robot's file.
     */
    final Set<String> moved;
    /** Whether anything other than poses has changed. */
    final boolean more;

    private PoseChanges(Set<String> moved, boolean more) {
        this.moved = Collections.unmodifiableSet(moved);
        this.more = more;
    }

    static PoseChanges of(List<FileChange> changes) {
        Map<String, Class<? extends SearObject>> classes = new HashMap<>();
        ObjectClasses.find().all().forEach(type -> classes.put(type.getSimpleName(), type));
        Set<String> moved = new LinkedHashSet<>();
        boolean more = false;
        for (FileChange change : changes) {
            SearObject before = read(change.path, change.before(), classes);
            SearObject after = read(change.path, change.after(), classes);
            boolean whole = before != null && after != null && before.getClass() == after.getClass()
                && (change.path.startsWith(ProjectFolder.ENVIRONMENT + "/") || after instanceof SEARrobot
                    || after instanceof Dynamics);
            if (!whole) {
                more = true;
                continue;
            }
            Map<String, Object> was = EditValues.of(before);
            Map<String, Object> is = EditValues.of(after);
            boolean placed = false;
            for (String parameter : PLACING) {
                Object present = is.remove(parameter);
                placed |= !String.valueOf(was.remove(parameter)).equals(String.valueOf(present));
            }
            more |= !was.equals(is);
            if (placed) {
                moved.add(after instanceof Dynamics ? ObjectFiles.stem(change.path) : after.getName());
            }
        }
        return new PoseChanges(moved, more);
    }

    private static SearObject read(String path, byte[] bytes, Map<String, Class<? extends SearObject>> classes) {
        ParsedObject parsed = bytes == null ? null : Xml.parse(bytes, path, classes, new ProblemList());
        return parsed == null || parsed.isBroken() ? null : (SearObject) parsed.object;
    }
}
