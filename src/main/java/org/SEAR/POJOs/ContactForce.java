// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;

/** The force with which objects other than the robot press on one of its parts, or on all of them. */
@Described("the force with which other objects press on a part of the robot; its own pose doesn't matter")
public class ContactForce extends SensorObject {
    @Param(doc = "name of the shape of the same robot that is pressed; default all parts but the wheels",
        text = TextRule.NAME, names = Shape.class)
    private String part;

    /** For reading from a file. */
    protected ContactForce() {
    }

    /** On every part of the robot except the wheels. */
    public ContactForce(String name) {
        super(name);
        created(ContactForce.class);
    }

    /** @param part the shape of the same robot that is pressed */
    public ContactForce(String name, Shape part) {
        super(name);
        this.part = Bumper.checkPart(this, part);
        created(ContactForce.class);
    }

    public String getPart() {
        return part;
    }

    /** @param newPart the shape of the same robot that is pressed */
    public void setPart(Shape newPart) {
        checkChangeable();
        part = Bumper.checkPart(this, newPart);
        changed();
    }
}
