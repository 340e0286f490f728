// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.arduino.WireRole;

/** A switch that is pressed while one part of its robot, or any part, touches an object other than the robot. */
@Described("a switch that is pressed while a part of its robot touches another object; its own pose doesn't matter")
public class Bumper extends SensorObject implements Wirable {
    @Param(doc = "name of the shape of the same robot that presses it; default all parts but the wheels",
        text = TextRule.NAME, names = Shape.class)
    private String part;

    /** For reading from a file. */
    protected Bumper() {
    }

    /** Pressed by every part of the robot except the wheels. */
    public Bumper(String name) {
        super(name);
        created(Bumper.class);
    }

    /** @param part the shape of the same robot that presses it */
    public Bumper(String name, Shape part) {
        super(name);
        this.part = checkPart(this, part);
        created(Bumper.class);
    }

    /** Returns the name of the part that presses a sensor, or throws with what is legal. */
    static String checkPart(SensorObject sensor, Shape wanted) {
        String label = sensor.label();
        if (wanted == null || !canPress(wanted)) {
            throw new IllegalArgumentException(
                label + ": " + (wanted == null ? "part is missing (None)" : wanted.label() + " can't press it")
                + ", legal: a shape that is a component of the same robot, and no wheel; "
                + sensor.getClass().getSimpleName() + "(name) is pressed by each of them");
        }
        if (sensor.robot() != null && wanted.robot() != null && sensor.robot() != wanted.robot()) {
            throw new IllegalArgumentException(label + ": " + wanted.label() + " is a part of " + wanted.robot()
                .label() + ", legal: a part of " + sensor.robot().label());
        }
        return wanted.getName();
    }

    /** Returns whether a kind of component can press a bumper. */
    public static boolean canPress(SearObject part) {
        return part instanceof Shape && !(part instanceof Wheel);
    }

    @Override
    public List<WireRole> getWireRoles() {
        return List.of(WireRole.SWITCH);
    }

    public String getPart() {
        return part;
    }

    /** @param newPart the shape of the same robot that presses it */
    public void setPart(Shape newPart) {
        checkChangeable();
        part = checkPart(this, newPart);
        changed();
    }
}
