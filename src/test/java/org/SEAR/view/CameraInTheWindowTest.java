// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import com.jme3.math.Vector3f;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.view.scene.ConeView;
import org.junit.Test;
import org.junit.runner.RunWith;

/** View lines of cameras, and a camera's picture in the corner of the window, in this process and in a separate one. */
@RunWith(UnderXvfb.class)
public class CameraInTheWindowTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 400;
    private static final int COLORS = 0xffffff;
    private static final int BLUE = 0xff;
    /** Least number of matching pixels. */
    private static final int MUCH = 10_000;

    /**
     * Makes a robot with a thermal and a depth camera before a red wall that fills their pictures. The wall has one
     * temperature, so its picture is blue.
     */
    private static Path project() throws Exception {
        Path folder = Files.createTempDirectory("view").resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        new Floor("floor", 16, 16);
        Box wall = new Box("wall", 6, 0.2, 6, 0);
        wall.setColor("red");
        wall.move(0, 3, 1);
        SEARrobot robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.2, 0.2, 0.1, 4));
        Camera heat = new Camera("heat", 0, 1.5, 0);
        heat.setKind(Camera.INFRARED);
        heat.setSize(640, 480);
        robot.addComponent(heat);
        Camera depth = new Camera("depth", 0, 1.5, 0);
        depth.setKind(Camera.DEPTH);
        depth.setSize(32, 24);
        robot.addComponent(depth);
        return folder;
    }

    /**
     * Returns the number of pixels in the lower right quarter with the blue of false colours, which nothing else in the
     * window has.
     */
    private static int blue(BufferedImage window) {
        int count = 0;
        for (int x = WIDTH / 2; x < WIDTH; x++) {
            for (int y = HEIGHT / 2; y < HEIGHT; y++) {
                count += (window.getRGB(x, y) & COLORS) == BLUE ? 1 : 0;
            }
        }
        return count;
    }

    @Test
    public void f6ShowsThePictureOfOneCameraAfterTheOtherAndF2TheLines() throws Exception {
        try (Views view = new Views(project(), new WindowOptions().setSize(WIDTH, HEIGHT))) {
            List<ConeView> cones = view.ask(() -> view.scene().world().cones());
            assertEquals(2, cones.size());
            assertTrue(view.is(() -> cones.stream().allMatch(ConeView::isVisible)));
            assertEquals("in front of the eye", 1.5,
                view.ask(() -> cones.get(0).node().localToWorld(new Vector3f(), null)).y, 0.1);
            Views.until("words without a picture",
                () -> view.is(() -> view.scene().hud().statusText().contains("heat: 640 x 480")));
            assertFalse("nobody looks", view.world.snapshot().readings.containsKey("heat"));
            view.press("F2");
            assertFalse(view.is(() -> cones.stream().anyMatch(ConeView::isVisible)));
            view.press("F6");
            Views.until("a picture", () -> view.is(() -> view.scene().hud().camera().shown() != null));
            assertEquals(320, (int) view.ask(() -> view.scene().hud().camera().shown().width));
            assertEquals("of the wall", BLUE,
                (int) view.ask(() -> view.scene().hud().camera().shown().pixel(160, 120)));
            view.frames(3);
            BufferedImage window = view.picture("camera");
            assertTrue("in the corner: " + blue(window), blue(window) > MUCH);
            view.press("F6");
            Views.until("that of the next camera", () -> view.is(() -> view.scene().hud().camera().shown() != null
                && view.scene().hud().camera().shown().words.contains("nearest 0.9")));
            assertEquals("each pixel as it is", 32, (int) view.ask(() -> view.scene().hud().camera().shown().width));
            view.press("F6");
            Views.until("none", () -> view.is(() -> view.scene().hud().camera().shown() == null));
            assertNull(view.ask(() -> view.scene().hud().camera().shown()));
            assertEquals(List.of(), view.warnings);
        }
    }

    @Test
    public void aWindowInAProcessOfItsOwnShowsItToo() throws Exception {
        Path pictures = Files.createTempDirectory("pictures");
        RunningWorld world = new RunningWorld(project());
        SimulatorWindow window = SimulatorWindow.open(world.runner, new WindowOptions().setSize(WIDTH, HEIGHT)
            .setTitle("SEAR elsewhere").setScreenshotFolder(pictures));
        try {
            assertNull(window.getProblem(), window.getProblem());
            Views.tool("mousemove", "640", "400");
            Views.tool("key", "F6");
            int[] number = {0};
            Views.until("the wall in the corner", () -> {
                try {
                    Views.tool("key", "F12");
                    Path file = pictures.resolve(String.format("sear-%04d.png", ++number[0]));
                    Views.until("a picture", () -> Files.exists(file) && isWhole(file));
                    return blue(ImageIO.read(file.toFile())) > MUCH;
                } catch (Exception e) {
                    throw new AssertionError(e);
                }
            });
        } finally {
            window.close();
            world.close();
        }
    }

    private static boolean isWhole(Path file) {
        try {
            return ImageIO.read(file.toFile()) != null;
        } catch (IOException | RuntimeException e) {
            return false;       // the file is still being written
        }
    }
}
