// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotSame;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;

import java.util.List;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Snapshot;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Lights shine as commanded, and snapshots contain their brightness. */
public class LedTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private Simulation start() throws Exception {
        new Floor("floor", 9, 9);
        SEARrobot rover = Worlds.roomba("rover", 0, 0, 0);
        rover.addComponent(new Led("lamp", 0, 0.1, 0.1));
        rover.addComponent(new Box("hat", 0.1, 0.1, 0.01, 0));
        rover.addComponent(new Led("tail", "blue", 0, 0.1, -0.1));
        return Worlds.start(project);
    }

    private static List<Double> lights(Simulation simulation) {
        simulation.step();
        return simulation.snapshot().robots.get(0).lights;
    }

    @Test
    public void lightsShineUntilTheNextOrder() throws Exception {
        try (Simulation simulation = start()) {
            assertEquals(List.of(0.0, 0.0), lights(simulation));
            simulation.getLight("lamp").setBrightness(1);
            simulation.getLight("rover/tail").setBrightness(0.25);
            assertEquals(List.of(1.0, 0.25), lights(simulation));
            Worlds.run(simulation, 5);
            assertEquals(1, simulation.getLight("lamp").getBrightness(), 0);
            simulation.reset();
            assertEquals("dark at the start", List.of(0.0, 0.0), lights(simulation));
        }
    }

    @Test
    public void lightsOfARobotAtRestAreShown() throws Exception {
        try (Simulation simulation = start()) {
            Worlds.run(simulation, 10);
            assertEquals(0, Worlds.physics(simulation).getBusyBodies());
            Snapshot.RobotState before = simulation.snapshot().robots.get(0);
            simulation.step();
            assertSame("nothing changed", before, simulation.snapshot().robots.get(0));
            simulation.getLight("lamp").setBrightness(0.5);
            assertEquals(List.of(0.5, 0.0), lights(simulation));
            assertNotSame(before, simulation.snapshot().robots.get(0));
            assertEquals("and stays asleep", 0, Worlds.physics(simulation).getBusyBodies());
        }
    }

    /** A light that a servo turns shines from its new place. */
    @Test
    public void aLightOnAServoTurnsWithIt() throws Exception {
        new Floor("floor", 9, 9);
        SEARrobot rover = Worlds.roomba("rover", 0, 0, 0);
        Servo mast = new Servo("mast", 0, 0.1, 0.1);
        Led lamp = new Led("lamp", 0, 0.2, 0.3);
        mast.mount(lamp);
        rover.addComponent(mast);
        rover.addComponent(lamp);
        try (Simulation simulation = Worlds.start(project)) {
            simulation.getServo("mast").setAngle(90);
            Worlds.run(simulation, 1);
            double[] expected = simulation.getPose("rover").transform(0.2, 0.2, 0.1);
            Pose is = simulation.getPose("lamp");
            assertEquals(expected[0], is.x, 1e-9);
            assertEquals(expected[1], is.y, 1e-9);
            assertEquals(expected[2], is.z, 1e-9);
        }
    }

    private static void refused(String message, Runnable order) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, order::run).getMessage());
    }

    @Test
    public void wrongOrdersAreRefused() throws Exception {
        try (Simulation simulation = start()) {
            refused("no led is called \"lamb\", legal: lamp tail", () -> simulation.getLight("lamb"));
            refused("led lamp of robot rover: brightness is 1.5, legal: 0 to 1", () -> simulation.getLight("lamp")
                .setBrightness(1.5));
            refused("led lamp of robot rover: brightness is -1, legal: 0 to 1", () -> simulation.getLight("lamp")
                .setBrightness(-1));
            refused("led lamp of robot rover: brightness is NaN, legal: 0 to 1", () -> simulation.getLight("lamp")
                .setBrightness(Double.NaN));
            assertEquals(0, simulation.getLight("lamp").getBrightness(), 0);
        }
    }

    @Test
    public void itsColorAndItsWireAreChecked() {
        Led lamp = new Led("lamp", "green", 0, 0.1, 0);
        assertEquals("#008000", lamp.getColor());
        lamp.setColor(null);
        assertEquals("#ff0000", lamp.getColor());
        Arduino uno = new Arduino("uno");
        refused("Arduino \"uno\": role is \"pwm\", legal for Led \"lamp\": light", () -> uno.wire(9, lamp, "pwm"));
        refused("Arduino \"uno\": pin 1 is not a digital pin of an Uno: 0 and 1 are its serial line, legal: 2 to 13, "
            + "A0 to A5 for light", () -> uno.wire(1, lamp));
    }
}
