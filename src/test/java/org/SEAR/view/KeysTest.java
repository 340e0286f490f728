// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import com.jme3.math.Vector3f;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.view.hud.Hud;
import org.SEAR.view.input.Key;
import org.SEAR.view.scene.BeamView;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;

/** Presses each key of the window on a real keyboard (an X server's) and checks the effect. */
@RunWith(UnderXvfb.class)
public class KeysTest {
    private static final double SLOW = 0.25;

    private Views view;

    @Before
    public void open() throws Exception {
        view = new Views(ViewProjects.room(), new WindowOptions().setSize(640, 400));
    }

    @After
    public void close() {
        view.close();
    }

    private Vector3f camera() throws Exception {
        return view.ask(() -> view.app().getCamera().getLocation().clone());
    }

    @Test
    public void uDrivesForwardFasterEachTimeAndSemicolonStops() throws Exception {
        view.press("u");
        Views.until("it drives", () -> view.world.robot().speed > 0.15);
        view.press("u", "u");
        Views.until("it drives faster", () -> view.world.robot().speed > 0.35);
        view.press("semicolon");
        Views.until("it stands", () -> Math.abs(view.world.robot().speed) < 0.01);
    }

    @Test
    public void jDrivesBackward() throws Exception {
        view.press("j");
        Views.until("it drives backward", () -> view.world.robot().speed < -0.15);
    }

    @Test
    public void hSpinsLeftAndKSpinsRight() throws Exception {
        view.press("h");
        Views.until("it spins left", () -> view.world.robot().turnRate > 0.5);
        view.press("k");
        Views.until("it spins right", () -> view.world.robot().turnRate < -0.5);
    }

    @Test
    public void enterPutsTheRobotBackToTheStart() throws Exception {
        double startX = view.world.robot().pose.x;
        double startZ = view.world.robot().pose.z;
        view.press("u");
        Views.until("it is away", () -> Math.hypot(view.world.robot().pose.x - startX, view.world.robot().pose.z
            - startZ) > 0.2);
        long step = view.world.snapshot().step;
        view.world.runner.setSpeed(SLOW);    // few steps, until a busy machine has drawn two pictures
        view.press("Return");
        Views.until("it is back", () -> Math.hypot(view.world.robot().pose.x - startX, view.world.robot().pose.z
            - startZ) < 0.02);
        assertTrue("started again", view.world.snapshot().step < step + 30);
        Views.until("it stands", () -> Math.abs(view.world.robot().speed) < 0.01);
    }

    @Test
    public void spaceTogglesTheFlycamAndSixKeysMoveIt() throws Exception {
        view.press("space");
        assertTrue(view.is(() -> view.scene().camera().isFlying()));
        Vector3f ahead = view.ask(() -> view.app().getCamera().getDirection().clone());
        Vector3f left = view.ask(() -> view.app().getCamera().getLeft().clone());
        flies("q", Vector3f.UNIT_Y);
        flies("z", Vector3f.UNIT_Y.negate());
        flies("w", ahead);
        flies("s", ahead.negate());
        flies("a", left);
        flies("d", left.negate());
        view.press("space");
        assertFalse(view.is(() -> view.scene().camera().isFlying()));
    }

    private void flies(String key, Vector3f direction) throws Exception {
        Vector3f from = camera();
        Views.tool("keydown", key);
        Views.until(key + " moves the camera", () -> moved(from, direction) > 0.1);
        Views.tool("keyup", key);
        view.frames(4);
        Vector3f rest = camera();
        view.frames(4);
        assertTrue("the camera stands after " + key, rest.distance(camera()) < 1e-5);
        assertTrue(key + " moves straight", rest.subtract(from).normalizeLocal().dot(direction) > 0.99);
    }

    private float moved(Vector3f from, Vector3f direction) {
        try {
            return camera().subtract(from).dot(direction);
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    @Test
    public void theFlycamKeysDoNothingToTheFollowCamera() throws Exception {
        Vector3f before = camera();
        view.press("w", "q", "d");
        assertTrue(before.distance(camera()) < 0.01);
    }

    @Test
    public void draggingTheMouseTurnsTheCameraAndTheWheelComesNearer() throws Exception {
        Vector3f direction = view.ask(() -> view.app().getCamera().getDirection().clone());
        float distance = camera().length();
        Views.tool("mousedown", "1");
        view.frames(3);
        Views.tool("mousemove", "740", "420");
        Views.until("the camera turns",
            () -> view.is(() -> view.app().getCamera().getDirection().angleBetween(direction) > 0.1));
        Views.tool("mouseup", "1");
        Views.tool("click", "4");
        Views.tool("click", "4");
        Views.until("the camera is nearer",
            () -> view.is(() -> view.app().getCamera().getLocation().length() < distance * 0.9));
    }

    @Test
    public void pPausesAndDotStepsOnce() throws Exception {
        view.press("p");
        assertTrue(view.world.runner.isPaused());
        Views.until("the panel says so", () -> view.is(() -> view.scene().hud().statusText().contains("PAUSED")));
        long step = view.world.pausedStep();
        view.press("period");
        Views.until("one step more", () -> view.world.snapshot().step == step + 1);
        view.frames(5);
        assertEquals(step + 1, view.world.snapshot().step);
        view.press("p");
        assertFalse(view.world.runner.isPaused());
        Views.until("it goes on", () -> view.world.snapshot().step > step + 5);
    }

    @Test
    public void plusAndMinusChangeTheSpeed() throws Exception {
        view.press("plus");
        assertEquals(2, view.world.runner.getSpeed(), 0);
        view.press("KP_Add");
        assertEquals(4, view.world.runner.getSpeed(), 0);
        view.press("minus", "KP_Subtract", "minus");
        assertEquals(0.5, view.world.runner.getSpeed(), 0);
    }

    @Test
    public void f1ShowsAllKeys() throws Exception {
        assertFalse(view.is(() -> view.scene().hud().isHelpShown()));
        view.press("F1");
        assertTrue(view.is(() -> view.scene().hud().isHelpShown()));
        for (Key key : Key.values()) {
            assertTrue(key.label, Hud.helpText().contains(key.label + "\t" + key.help));
        }
        view.picture("help");
        view.press("F1");
        assertFalse(view.is(() -> view.scene().hud().isHelpShown()));
    }

    @Test
    public void f2HidesAllBeamsAndNumbersSingleOnes() throws Exception {
        assertEquals(2, (int) view.ask(() -> view.scene().world().beams().size()));
        view.press("F2");
        assertFalse(view.is(() -> view.scene().world().beams().stream().anyMatch(BeamView::isVisible)));
        assertNull("no label without beams", view.ask(() -> view.scene().labels().text("Ping1")));
        view.press("F2");
        assertTrue(view.is(() -> view.scene().world().beams().stream().allMatch(BeamView::isVisible)));
        view.press("1");
        assertFalse(view.is(() -> view.scene().world().beams().get(0).isVisible()));
        assertTrue(view.is(() -> view.scene().world().beams().get(1).isVisible()));
        view.press("1");
        assertTrue(view.is(() -> view.scene().world().beams().get(0).isVisible()));
    }

    @Test
    public void f3ShowsTheShapesOfThePhysics() throws Exception {
        assertFalse(view.is(() -> view.scene().shapes().isVisible()));
        view.press("F3");
        assertTrue(view.is(() -> view.scene().shapes().isVisible()));
        Views.until("wheel rays and contacts are drawn", () -> view.is(() -> view.scene().shapes().lineCount() >= 4));
        view.picture("physics-shapes");
        view.press("F3");
        assertFalse(view.is(() -> view.scene().shapes().isVisible()));
    }

    @Test
    public void f4FoldsThePanelsToTheLineWithTheTime() throws Exception {
        Views.until("all numbers", () -> view.is(() -> view.scene().hud().shownText().contains("Odometer1: ")));
        view.press("F4");
        Views.until("one line", () -> view.is(() -> view.scene().hud().shownText().matches("time [^\n]*")));
        view.picture("folded");
        view.press("F1", "F1");
        Views.until("one line after the help, too",
            () -> view.is(() -> view.scene().hud().shownText().matches("time [^\n]*")));
        view.press("F4");
        Views.until("all numbers again", () -> view.is(() -> view.scene().hud().shownText().contains("Odometer1: ")));
    }

    @Test
    public void f5HidesTheLabelsWithLiveValues() throws Exception {
        String first = view.ask(() -> view.scene().labels().text("LIDAR1"));
        assertNotNull(first);
        assertTrue(first, first.startsWith("LIDAR1  "));
        view.press("F5");
        assertNull(view.ask(() -> view.scene().labels().text("LIDAR1")));
    }

    @Test
    public void f12WritesAPicture() throws Exception {
        Path folder = Views.report();
        long before;
        try (var files = Files.list(folder)) {
            before = files.filter(file -> file.getFileName().toString().startsWith("sear-")).count();
        }
        view.press("F12");
        Views.until("the panel names the file",
            () -> view.is(() -> view.scene().hud().messagesText().contains("picture saved")));
        try (var files = Files.list(folder)) {
            assertEquals(before + 1, files.filter(file -> file.getFileName().toString().startsWith("sear-")).count());
        }
    }

    @Test
    public void tabFollowsTheNextRobot() throws Exception {
        view.press("Tab");
        assertTrue(view.ask(() -> view.scene().hud().messagesText()).contains("following Roomba1"));
    }
}
