// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Collection;
import java.util.List;

/** The joints of the grammar. */
public final class JointTypes implements ObjectTypes {
    @Override
    public Collection<Class<? extends SearObject>> types() {
        return List.of(Hinge.class, Slider.class, BallJoint.class, FixedJoint.class, Rope.class);
    }
}
