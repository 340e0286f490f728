// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.ScriptSession;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** With two services in a program, only one receives the messages about a new object. */
public class ScriptSessionTest {
    private static final String LATE = " was made while a simulation runs: it appears at the next startSimulation()";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<String> first = new ArrayList<>();
    private final List<String> second = new ArrayList<>();
    private final ScriptSession one = new ScriptSession(first::add);
    private final ScriptSession two = new ScriptSession(second::add);

    @Before
    public void open() {
        one.open();
        two.open();
    }

    @After
    public void close() {
        one.close();
        two.close();
    }

    @Test
    public void thatWhoseSimulationRuns() {
        one.begin(null, () -> true);
        two.anotherProject();
        new Box("a", 1, 1, 1, 0);
        assertEquals("[Box \"a\"" + LATE + "]", first.toString());
        assertEquals("[]", second.toString());
        one.end();
        new Box("b", 1, 1, 1, 0);
        two.begin(null, () -> true);
        new Box("c", 1, 1, 1, 0);
        assertEquals(1, first.size());
        assertEquals("[Box \"c\"" + LATE + "]", second.toString());
    }

    @Test
    public void thatWhichWasUsedLastWhileNoSimulationRuns() {
        warn("a");
        assertEquals("0 1", first.size() + " " + second.size());
        one.anotherProject();
        warn("b");
        assertEquals("1 1", first.size() + " " + second.size());
        one.close();
        one.projectTaken();
        warn("c");
        assertEquals("closed ones stay closed", "1 2", first.size() + " " + second.size());
        assertTrue(second.get(1), second.get(1).startsWith("LIDAR \"c\""));
    }

    private static void warn(String name) {
        LIDAR lidar = new LIDAR(name, 8, 180, 0.5);
        lidar.setPorts(name + " uart", name + " user");
        lidar.setSpread(270);
    }

    /** An object that a simulation has read is moved by that simulation's service. */
    @Test
    public void objectsOfARunningSimulationAreMovedByItsService() {
        Box early = new Box("early", 1, 1, 1, 1);
        List<String> moved = new ArrayList<>();
        one.begin(acts(moved, "one"), () -> true);
        Box late = new Box("late", 1, 1, 1, 1);
        Gravity gravity = new Gravity("gravity", "Mars");
        early.setVelocity(1, 0, 0);
        late.setVelocity(2, 0, 0);
        one.end();
        two.begin(acts(moved, "two"), () -> true);
        early.setSpin(0, 3, 0);
        gravity.setAcceleration(1.62);
        late.setVelocity(4, 0, 0);
        assertEquals("[one early 1.0, two early 3.0, two gravity 1.62, two late 4.0]", moved.toString());
    }

    private static ScriptSession.Acts acts(List<String> moved, String who) {
        return new ScriptSession.Acts() {
            @Override
            public void setVelocity(String name, double x, double y, double z) {
                moved.add(who + " " + name + " " + x);
            }

            @Override
            public void setSpin(String name, double x, double y, double z) {
                moved.add(who + " " + name + " " + y);
            }

            @Override
            public void setGravity(double acceleration) {
                moved.add(who + " gravity " + acceleration);
            }
        };
    }
}
