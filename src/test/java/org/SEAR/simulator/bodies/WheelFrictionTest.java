// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.function.Consumer;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** The grip of a tyre follows the product of the coefficients of wheel and ground, on floors and on terrain. */
public class WheelFrictionTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Returns the distance of a fast-commanded car after a second, and the distance by its wheels, metres. */
    private double[] drive(Shape ground, Consumer<SEARrobot> change) throws Exception {
        SEARrobot car = Robots.fourWheeled("car");
        if (ground instanceof Terrain) {
            car.place(36.485, -84.2308333, 0);
        }
        change.accept(car);
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 1);
            Pose from = simulation.getPose("car");
            simulation.getMotor("leftMotor").setPower(1);
            simulation.getMotor("rightMotor").setPower(1);
            Worlds.run(simulation, 1);
            Pose to = simulation.getPose("car");
            return new double[] {from.rotateBack(to.x - from.x, to.y - from.y, to.z - from.z)[2],
                simulation.getMotor("leftMotor").getSpeed() * 0.06};
        }
    }

    private static Consumer<SEARrobot> wheels(double friction) {
        return robot -> robot.getWheels().forEach(wheel -> wheel.setFriction(friction));
    }

    private static Shape floor(Double friction) {
        Floor floor = new Floor("floor", 60, 60);
        if (friction != null) {
            floor.setFriction(friction);
        }
        return floor;
    }

    @Test
    public void withoutFrictionItDoesNotMoveAtAll() throws Exception {
        assertEquals(0, drive(floor(0.0), robot -> { })[0], 1e-6);
        double[] slipping = drive(floor(null), wheels(0));
        assertEquals("wheels without", 0, slipping[0], 1e-6);
        assertEquals("they turn on the spot as fast as the motor does", 16 * 0.06, slipping[1], 0.01);
    }

    /** On low friction it accelerates with friction * g instead of the motors' limit. */
    @Test
    public void onLittleFrictionItSlips() throws Exception {
        double expected = 0.05 * 9.81 / 2;
        assertEquals("floor", expected, drive(floor(0.04), robot -> { })[0], 0.03 * expected);
        assertEquals("wheels", expected, drive(floor(null), wheels(0.0625))[0], 0.03 * expected);
        double[] both = drive(floor(0.2), wheels(0.25));
        assertEquals("the product of both", expected, both[0], 0.03 * expected);
        assertTrue("its wheels are faster", both[1] > 0.8);
    }

    @Test
    public void theDefaultGripIsOne() throws Exception {
        double usual = drive(floor(null), robot -> { })[0];
        assertTrue("way " + usual, usual > 0.7);
        assertEquals("1.25 on 0.8", usual, drive(floor(0.8), wheels(1.25))[0], 0);
    }

    @Test
    public void terrainCounts() throws Exception {
        Terrain terrain = new Terrain("jacksboro", "terrain/jacksboro.tif");
        terrain.setArea(36.486, -84.2298333, 1000, 1000);
        double[] dry = drive(terrain, robot -> { });
        terrain.setFriction(0);
        double[] icy = drive(terrain, robot -> { });
        assertTrue("dry " + dry[0] + ", wheels " + dry[1], Math.abs(dry[0]) > 0.3);
        assertEquals("on ice wheels turn freely", 16 * 0.06, icy[1], 0.01);
    }
}
