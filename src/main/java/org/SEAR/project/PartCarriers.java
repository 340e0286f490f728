// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;

/**
 * Which servo or joint moves each component of a robot. A servo moves the parts mounted on it. A joint moves its second
 * part and those mounted on it; a joint whose second part already has a servo or an earlier joint closes a loop.
 * Components are numbered as in the robot. Immutable, any thread.
 */
public final class PartCarriers {
    /** Number that stands for the robot's own body. */
    public static final int NONE = -1;

    private final List<SearObject> parts;
    private final List<String> names = new ArrayList<>();
    private final int[] movers;

    /** @param parts all components of a robot */
    public PartCarriers(List<SearObject> parts) {
        this.parts = parts;
        parts.forEach(part -> names.add(part.getName()));
        movers = new int[parts.size()];
        Arrays.fill(movers, NONE);
        for (int i = 0; i < movers.length; i++) {
            if (parts.get(i) instanceof Servo) {
                claim(((Servo) parts.get(i)).getPartNames(), i);
            }
        }
        for (int i = 0; i < movers.length; i++) {
            if (parts.get(i) instanceof Joint) {
                claim(List.of(((Joint) parts.get(i)).getSecond()), i);
            }
        }
        for (int i = 0; i < movers.length; i++) {
            if (parts.get(i) instanceof Joint) {
                claim(((Joint) parts.get(i)).getPartNames(), mover(((Joint) parts.get(i)).getSecond()));
            }
        }
    }

    private void claim(List<String> moved, int mover) {
        for (String name : moved) {
            int part = names.indexOf(name);
            if (part >= 0 && movers[part] == NONE) {
                movers[part] = mover;
            }
        }
    }

    /** Returns the number of the servo or joint that moves a component; {@link #NONE} if none does. */
    public int mover(int part) {
        return movers[part];
    }

    /** Returns the number of the servo or joint that moves a component; {@link #NONE} for null and unknown names. */
    public int mover(String part) {
        int index = names.indexOf(part);
        return index < 0 ? NONE : movers[index];
    }

    /** Returns the number of the servo or joint that moves a servo or a joint's first part. */
    public int carrier(int mover) {
        SearObject object = parts.get(mover);
        return object instanceof Joint ? mover(((Joint) object).getFirst()) : movers[mover];
    }

    /** Returns whether a component is a servo, or a joint that moves its second part. */
    public boolean moves(int part) {
        SearObject object = parts.get(part);
        return object instanceof Servo || object instanceof Joint && mover(((Joint) object).getSecond()) == part;
    }

    /** Returns whether a servo or joint moves itself, by others. */
    public boolean isCircular(int mover) {
        int on = mover;
        for (int i = 0; i <= movers.length && on != NONE; i++) {
            on = carrier(on);
        }
        return on != NONE;
    }
}
