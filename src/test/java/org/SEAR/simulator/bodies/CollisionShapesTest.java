// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Sphere;
import org.SEAR.Slow;
import org.SEAR.collision.Meshes;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Models that collide by hull, by convex parts and by triangles. */
@Category(Slow.class)
public class CollisionShapesTest {
    /** Overlap and gap of a contact at rest, metres. */
    private static final double RESTS = 2e-3;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Before
    public void putFloor() {
        new Floor("floor", 20, 20);
    }

    private Model model(String name, double mass, String collision, Meshes mesh) throws Exception {
        project.put("assets/" + name + ".obj", mesh.obj());
        Model model = new Model(name, name + ".obj", mass);
        model.setCollision(collision);
        return model;
    }

    private static Meshes pair() {
        return new Meshes().box(-2, 0, -0.5, -1, 1, 0.5).box(1, 0, -0.5, 2, 1, 0.5);
    }

    private static Meshes channel() {
        return new Meshes().box(-0.5, 0, -0.5, 0.5, 0.1, 0.5).box(-0.5, 0.1, -0.5, -0.4, 0.5, 0.5)
            .box(0.4, 0.1, -0.5, 0.5, 0.5, 0.5);
    }

    private Pose after(double seconds, String name) throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, seconds);
            return Worlds.body(simulation, name).getPose();
        }
    }

    @Test
    public void aBallFallsBetweenTheCubesOfOneModel() throws Exception {
        Model pair = model("pair", 100, Model.PARTS, pair());
        new Sphere("ball", 0.3, 1).move(0, 1.4, 0);
        assertEquals(0.3, after(1.5, "ball").y, RESTS);
        pair.setCollision("hull");
        assertEquals(1.3, after(1.5, "ball").y, RESTS);
    }

    @Test
    public void aChannelHoldsABall() throws Exception {
        model("channel", 5, Model.PARTS, channel());
        new Sphere("ball", 0.1, 1).move(0.1, 0.4, 0.1);
        assertEquals(0.2, after(1, "ball").y, RESTS);
    }

    @Test
    public void anArchStandsOnItsFeetOverABox() throws Exception {
        model("arch", 5, Model.PARTS, channel().rotated(Math.PI, 0)).move(0, 0.5, 0);
        new Box("box", 0.5, 0.3, 0.5, 0).move(0, 0.15, 0);
        Pose arch = after(1, "arch");
        assertEquals(0.5, arch.y, RESTS);
        assertEquals(1, Math.abs(arch.qw), 1e-6);
    }

    @Test
    public void aRingFallsOverAPole() throws Exception {
        model("ring", 1, Model.PARTS, new Meshes().torus(0.3, 0.05, 32, 12)).move(0, 0.6, 0);
        new Cylinder("pole", 0.1, 0.5, 0).move(0, 0.25, 0);
        Pose ring = after(1, "ring");
        assertEquals(0.05, ring.y, 5 * RESTS);
    }

    @Test
    public void aBucketOnARobotHoldsABall() throws Exception {
        SEARrobot cart = Worlds.cart("cart", 10, 0.1, 0.3, new double[] {-0.3, 0.3}, 0, 0, 0, 0);
        Model bucket = model("bucket", 0, Model.PARTS, channel());
        bucket.move(0, 0.3, 0);
        cart.addComponent(bucket);
        new Sphere("ball", 0.1, 0.1).move(0, 0.8, 0);
        assertTrue(after(1, "ball").y > 0.5);
        assertTrue(after(1, "ball").y < 0.8);
    }

    @Test
    public void aFixedModelCanCollideByItsHull() throws Exception {
        model("channel", 0, Model.HULL, channel());
        new Sphere("ball", 0.1, 1).move(0, 0.7, 0);
        assertEquals(0.6, after(1, "ball").y, RESTS);
    }

    @Test
    public void massPropertiesAreThoseOfTheSolid() throws Exception {
        Model channel = model("channel", 5, Model.PARTS, channel());
        MassProperties parts = properties();
        channel.setCollision(null);
        MassProperties hull = properties();
        assertArrayEquals(hull.centre(), parts.centre(), 0);
        assertArrayEquals(hull.inertia.toRows()[0], parts.inertia.toRows()[0], 0);
        double volume = 0.1 + 2 * 0.04;
        assertEquals((0.1 * 0.05 + 2 * 0.04 * 0.3) / volume, parts.centre()[1], 1e-6);
    }

    private MassProperties properties() throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            return Worlds.body(simulation, "channel").getMassProperties();
        }
    }

    @Test
    public void anOpenModelHasTheMassPropertiesOfItsParts() throws Exception {
        model("channel", 5, Model.PARTS, pair().without(13).without(1));
        assertEquals(0, properties().centre()[0], 0.1);
        assertTrue("at least that of two points", properties().inertia.yy > 5 * 1.5 * 1.5);
    }

    @Test
    public void twoRunsGiveTheSamePoses() throws Exception {
        model("ring", 1, Model.PARTS, new Meshes().torus(0.3, 0.05, 16, 8)).move(0, 0.4, 0);
        new Sphere("ball", 0.1, 1).move(0.25, 0.9, 0.02);
        assertEquals(poses(), poses());
    }

    private List<String> poses() throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 1.5);
            return Worlds.physics(simulation).getBodies().stream()
                .map(body -> body.getPose().x + " " + body.getPose().y + " " + body.getPose().qx)
                .collect(Collectors.toList());
        }
    }

    @Test
    public void aMovableModelHasNoExactCollisions() throws Exception {
        Model model = model("pair", 0, null, pair());
        assertEquals("exact", model.getCollision());
        model.setMass(1);
        assertEquals("hull", model.getCollision());
        assertRefused("parts", () -> model.setCollision("exact"));
        model.setMass(0);
        model.setCollision("exact");
        assertRefused("parts", () -> model.setMass(1));
        assertRefused("parts", () -> new SEARrobot("robot").addComponent(model));
        assertRefused("hull, parts, exact", () -> model.setCollision("box"));
    }

    private static void assertRefused(String remedy, Runnable call) {
        String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
        assertTrue(message, message.contains(remedy));
    }
}
