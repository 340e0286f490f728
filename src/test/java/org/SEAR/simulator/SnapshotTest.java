// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** Content of a snapshot, which keeps no reference to the running world. */
public class SnapshotTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private Simulation roomba() throws Exception {
        new Floor("floor", 20, 20);
        SEARrobot robot = Worlds.roomba("roomba", 1, 2, 30);
        robot.getComponents().stream().filter(part -> part instanceof Dynamics)
            .forEach(part -> ((Dynamics) part).setPorts("oiUart", "oiUser"));
        return Worlds.start(project);
    }

    private static Snapshot.RobotState robot(Simulation simulation) {
        return simulation.snapshot().robots.get(0);
    }

    @Test
    public void aRobotIsCommandedWhileItsOpenInterfaceTakesDriveCommands() throws Exception {
        Simulation simulation = roomba();
        Worlds.run(simulation, 0.5);
        assertFalse(robot(simulation).commanded);
        write(simulation, 128);
        assertFalse("passive", robot(simulation).commanded);
        write(simulation, 131);
        assertTrue("safe", robot(simulation).commanded);
        write(simulation, 132);
        assertTrue("full", robot(simulation).commanded);
        write(simulation, 128);
        assertFalse("passive again", robot(simulation).commanded);
    }

    private static void write(Simulation simulation, int opcode) {
        simulation.getLines().get(0).write(new byte[] {(byte) opcode});
        Worlds.run(simulation, 0.2);
    }

    @Test
    public void aWheelIsWhereTheSnapshotHasItAndADynamicsWhereTheRobotIs() throws Exception {
        Simulation simulation = roomba();
        simulation.post(world -> world.getRobots().get(0).drive(0.3, 1));
        Worlds.run(simulation, 1);
        Snapshot.RobotState robot = robot(simulation);
        assertSamePose(robot.pose, simulation.getPose("roomba"));
        assertSamePose(robot.pose, simulation.getPose("roombaDynamics"));
        assertSamePose(robot.pose.times(robot.wheels.get(1)), simulation.getPose("roombaRight"));
        assertSamePose(robot.pose.times(robot.wheels.get(3)), simulation.getPose("roombaBack"));
    }

    private static void assertSamePose(Pose expected, Pose actual) {
        assertArrayEquals(new double[] {expected.x, expected.y, expected.z, expected.qx, expected.qy, expected.qz,
            expected.qw},
            new double[] {actual.x, actual.y, actual.z, actual.qx, actual.qy, actual.qz, actual.qw}, 1e-12);
    }

    @Test
    public void aSnapshotIsImmutableAndIndependentOfTheWorld() throws Exception {
        Simulation simulation = roomba();
        simulation.post(world -> world.getRobots().get(0).drive(0.3, 1));
        Worlds.run(simulation, 1);
        Snapshot snapshot = simulation.snapshot();
        String before = snapshot.robots.get(0).wheels.toString();
        Worlds.run(simulation, 1);
        assertEquals(before, snapshot.robots.get(0).wheels.toString());
        Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        assertHarmless(snapshot, seen);
        assertTrue(seen.size() > 5);
    }

    private static void assertHarmless(Object object, Set<Object> seen) throws IllegalAccessException {
        if (object == null || !seen.add(object)) {
            return;
        }
        String name = object.getClass().getName();
        if (object instanceof Map) {
            assertHarmless(((Map<?, ?>) object).values(), seen);
        } else if (name.startsWith("org.SEAR.")) {
            assertTrue("a snapshot holds a " + name,
                name.matches("org\\.SEAR\\.(simulator\\.Snapshot.*|robot\\.wheel\\.WheelPoses|geometry\\.Pose)"));
            for (Field field : object.getClass().getDeclaredFields()) {
                if (!Modifier.isStatic(field.getModifiers()) && !field.getType().isPrimitive()) {
                    field.setAccessible(true);
                    assertHarmless(field.get(object), seen);
                }
            }
        } else if (object instanceof Collection) {
            for (Object element : (Collection<?>) object) {
                assertHarmless(element, seen);
            }
        }
    }
}
