// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;

/** Force and torque that a joint exerts on its second object, along the sensor's axes. */
@Described("force and torque that a joint exerts on its second object, at the joint, along the sensor's axes")
public class ForceTorque extends SensorObject {
    @Param(doc = "name of the joint", text = TextRule.NAME, required = true, names = Joint.class, needed = true)
    private String joint;

    /** For reading from a file. */
    protected ForceTorque() {
    }

    /**
     * At a joint; {@code rotate} turns its axes in the body frame.
     *
     * @param joint its name
     */
    public ForceTorque(String name, String joint) {
        super(name);
        this.joint = joint;
        created(ForceTorque.class);
    }

    /** Returns the name of the joint. */
    public String getJoint() {
        return joint;
    }
}
