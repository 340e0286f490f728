// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import static org.junit.Assert.assertEquals;

import com.jme3.asset.AssetManager;
import com.jme3.math.ColorRGBA;
import com.jme3.math.Vector3f;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.system.JmeSystem;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.files.Assets;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.scene.Movement;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.view.link.RunnerLink;
import org.junit.Rule;
import org.junit.Test;

/** Parts turned by a servo and a steered wheel appear turned, and lights lit or dark; without a display. */
public class TurretInTheWindowTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static void robot() {
        SEARrobot robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 3));
        Servo neck = new Servo("neck", 0, 0.1, 0);
        Box head = new Box("head", 0.1, 0.1, 0.1, 0);
        head.move(0, 0.1, 0.2);
        Distance ping = new Distance("ping", "laser", 0, 0.1, 0.3, 0, 0, 0);
        Led eye = new Led("eye", 0, 0.1, 0.25);
        neck.mount(eye);
        neck.mount(head);
        neck.mount(ping);
        robot.addComponent(neck);
        robot.addComponent(head);
        robot.addComponent(ping);
        robot.addComponent(eye);
        robot.addWheel(new Wheel("rear", 0.05, 0.03, 1, 0, 0, -0.2));
        Wheel front = new Wheel("front", 0.05, 0.03, 2, 0, 0, 0.2);
        front.setSteering(40);
        robot.addWheel(front);
    }

    @Test
    public void partsBeamsAndWheelsTurn() throws Exception {
        robot();
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            RunnerLink link = new RunnerLink(new SimulationRunner(world), () -> false);
            WorldView view = view(link);
            world.getServo("neck").setAngle(90);
            world.getRobots().get(0).steer(30);
            for (int i = 0; i < 30; i++) {
                world.step();
            }
            Movement movement = new Movement();
            movement.advance(link.snapshot(), 0, 0);
            view.update(movement);
            near(new Vector3f(0.2f, 0.1f, 0), view.robot(0).getChild("head").getLocalTranslation());
            near(new Vector3f(0.25f, 0.1f, 0), view.robot(0).getChild("eye").getLocalTranslation());
            near(new Vector3f(0.3f, 0.1f, 0), view.beams().get(0).node().getLocalTranslation());
            near(new Vector3f(1, 0, 0), view.beams().get(0).node().getLocalRotation().mult(Vector3f.UNIT_Z));
            near(new Vector3f((float) Math.cos(Math.toRadians(30)), 0, (float) -Math.sin(Math.toRadians(30))),
                view.wheel(0, 1).getLocalRotation().mult(Vector3f.UNIT_X));
            link.close();
        }
    }

    @Test
    public void lightsAreSeenLitOrDark() throws Exception {
        robot();
        SEARrobot second = new SEARrobot("second");
        second.addComponent(new Dynamics("second drive", 3, 0, 1, 0, 0, 0, 0));
        second.addComponent(new Led("lamp", "#ff8000", 0, 0.1, 0.2));
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            RunnerLink link = new RunnerLink(new SimulationRunner(world), () -> false);
            WorldView view = view(link);
            near(new Vector3f(0, 0.1f, 0.2f), view.robot(1).getChild(1).getLocalTranslation());
            Geometry bulb = (Geometry) ((Node) view.robot(1).getChild(1)).getChild(0);
            ColorRGBA dark = (ColorRGBA) bulb.getMaterial().getParam("Color").getValue();
            world.getLight("lamp").setBrightness(1);
            world.step();
            Movement movement = new Movement();
            movement.advance(link.snapshot(), 0, 0);
            view.update(movement);
            ColorRGBA lit = (ColorRGBA) bulb.getMaterial().getParam("Color").getValue();
            assertEquals(0xff8000, lit.asIntARGB() & 0xffffff);
            assertEquals(0.2, dark.r, 1e-6);
            link.close();
        }
    }

    private WorldView view(RunnerLink link) throws Exception {
        AssetManager manager = JmeSystem.newAssetManager(JmeSystem.getPlatformAssetConfigURL());
        ModelLoader.prepare(manager, new Assets(project.folder()));
        Materials materials = new Materials(manager, false, warning -> {
            throw new AssertionError(warning);
        });
        return new WorldView(link.project(), new SceneBuilder(new ModelLoader(link.project().getAssets()), materials,
            warning -> {
            throw new AssertionError(warning);
        }), link.beams(), materials);
    }

    private static void near(Vector3f expected, Vector3f is) {
        assertEquals("at " + is, 0, expected.distance(is), 1e-4);
    }
}
