// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.ParameterTable;

/** The names of objects and robots in joints, when one is renamed or deleted. Guarded by the project lock. */
final class JointReferences {
    private JointReferences() {
    }

    /** Replaces an old name of an object in all joints, and of a joint in all sensors. */
    static void follow(EditDraft draft, String old, String now) throws IOException {
        for (String path : draft.list(false)) {
            Joint joint = joint(draft, path, old);
            if (joint != null) {
                ParameterTable.of(joint.getClass()).get(old.equals(joint.getFirst()) ? "first" : "second")
                    .set(joint, now);
                draft.write(path, joint);
            }
            SearObject object = draft.readIfWhole(path);
            if (object instanceof AxisJoint && old.equals(((AxisJoint) object).getGear())) {
                ParameterTable.of(object.getClass()).get("gear").set(object, now);
                draft.write(path, object);
            }
        }
        for (String path : draft.list(true)) {
            SearObject sensor = draft.readIfWhole(path);
            if (sensor instanceof ForceTorque && old.equals(((ForceTorque) sensor).getJoint())) {
                ParameterTable.of(ForceTorque.class).get("joint").set(sensor, now);
                draft.write(path, sensor);
            }
        }
    }

    /** Deletes the joints of an object; returns them. */
    static List<SearObject> delete(EditDraft draft, String name) throws IOException {
        List<SearObject> deleted = new ArrayList<>();
        for (String path : draft.list(false)) {
            Joint joint = joint(draft, path, name);
            if (joint != null) {
                draft.delete(path);
                deleted.add(joint);
            }
        }
        return deleted;
    }

    /** Returns the joint in a file if it names the object; otherwise null. */
    private static Joint joint(EditDraft draft, String path, String name) throws IOException {
        SearObject object = draft.readIfWhole(path);
        boolean named = object instanceof Joint
            && (name.equals(((Joint) object).getFirst()) || name.equals(((Joint) object).getSecond()));
        return named ? (Joint) object : null;
    }
}
