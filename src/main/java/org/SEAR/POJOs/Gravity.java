// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.ScriptText;

/**
 * Gravity of the world, downwards (-y) and equal everywhere. A project has at most one; without one it is that of the
 * Earth. Its pose has no meaning.
 */
@Described("gravity of the world, equal everywhere; a project has at most one, and that of the Earth without one; its "
    + "position and rotation have no meaning")
public class Gravity extends SearObject {
    /** Standard gravity of the Earth as SEAR uses it, m/s^2. */
    public static final double EARTH = 9.81;
    /** Largest legal acceleration, m/s^2: four times Jupiter's. */
    public static final double STRONGEST = 100;
    /** Names of bodies and the gravity at their surface, m/s^2: NASA's planetary fact sheets. */
    private static final Map<String, Double> BODIES = new LinkedHashMap<>();

    static {
        BODIES.put("Earth", EARTH);
        BODIES.put("Moon", 1.62);
        BODIES.put("Mars", 3.71);
    }

    @Param(doc = "acceleration downwards: 9.81 on the Earth, 1.62 on the Moon, 3.71 on Mars, 0 without gravity",
        unit = "m/s2", max = STRONGEST, required = true, initial = "1.62")
    private double acceleration = EARTH;
    private final int madeAfter = ScriptSessions.ALL.starts();

    /** For reading from a file. */
    protected Gravity() {
    }

    /** @param acceleration m/s^2 downwards, 0 to 100 */
    public Gravity(String name, double acceleration) {
        super(name);
        this.acceleration = acceleration;
        created(Gravity.class);
    }

    /** @param body Earth, Moon or Mars */
    public Gravity(String name, String body) {
        this(name, of(name, body));
    }

    private static double of(String name, String body) {
        String called = ScriptText.of(body);
        if (!BODIES.containsKey(called)) {
            throw new IllegalArgumentException("Gravity \"" + name + "\": body is " + ParameterTable.quote(called)
                + ", legal: " + String.join(", ", BODIES.keySet()) + ", or a number of m/s^2");
        }
        return BODIES.get(called);
    }

    @Override
    String whyNoComponent() {
        return " acts on the whole world and can't be a component";
    }

    /** Returns the acceleration, m/s^2 downwards. */
    public double getAcceleration() {
        return acceleration;
    }

    /**
     * Sets the acceleration. If a simulation runs that was started after the object was created, the call changes
     * gravity in that simulation between two steps, until {@code reset()}, and leaves the file unchanged.
     *
     * @param newAcceleration m/s^2 downwards, 0 to 100
     */
    public void setAcceleration(double newAcceleration) {
        double checked = checked("acceleration", newAcceleration);
        ScriptSession.Acts running = ScriptSessions.ALL.actsFor(madeAfter);
        if (running != null) {
            running.setGravity(checked);
            return;
        }
        acceleration = checked;
        changed();
    }
}
