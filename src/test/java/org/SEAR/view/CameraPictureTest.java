// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.scene.Spatial.CullHint;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.BrownLens;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.camera.CameraRenderer;
import org.SEAR.camera.RenderJob;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;
import org.SEAR.sensors.Truth;
import org.junit.Test;
import org.junit.runner.RunWith;

/**
 * A camera sees what the window shows: pictures of the same views of all examples have a high structural similarity
 * (Wang, Bovik, Sheikh and Simoncelli, "Image quality assessment: from error visibility to structural similarity",
 * 2004). The window's picture is drawn at twice the size and scaled down, because without a graphics card it doesn't
 * filter textures.
 */
@RunWith(UnderXvfb.class)
public class CameraPictureTest {
    private static final double ALIKE = 0.9;
    private static final int WIDTH = 320;
    private static final int HEIGHT = 200;
    private static final int FINER = 2;

    @Test
    public void allExamplesLookAlikeInTheWindowAndToACamera() throws Exception {
        List<String> names;
        try (Stream<Path> files = Files.list(Path.of(System.getProperty("sear.root", "."), "examples"))) {
            names = files.map(file -> file.getFileName().toString()).filter(file -> file.endsWith(".sear"))
                .map(file -> file.replace(".sear", "")).sorted().collect(Collectors.toList());
        }
        List<String> unlike = new ArrayList<>();
        for (String name : names) {
            double similarity = similarity(name, Examples.folder(name));
            System.out.printf(Locale.ROOT, "%s: structural similarity %.3f%n", name, similarity);
            if (similarity < ALIKE) {
                unlike.add(String.format(Locale.ROOT, "%s: %.3f", name, similarity));
            }
        }
        assertEquals(List.of(), unlike);
        assertTrue(names.size() >= 9);
    }

    /** Markers, chessboards and pictures have the same pictures on the same sides in the same orientation. */
    @Test
    public void platesLookAlike() throws Exception {
        double similarity = similarity("plates", ViewProjects.plates());
        assertTrue("structural similarity " + similarity, similarity > ALIKE);
    }

    private static double similarity(String example, Path folder) throws Exception {
        try (Views view = new Views(folder, new WindowOptions().setSize(FINER * WIDTH, FINER * HEIGHT))) {
            view.press("F2");
            view.world.runner.setPaused(true);
            view.ask(() -> {
                view.app().getGuiNode().setCullHint(CullHint.Always);
                hideWhatIsNoBody(view);
                return null;
            });
            view.frames(20);
            BufferedImage window = smaller(view.picture("camera-" + example + "-window"));
            Camera eye = view.ask(() -> view.app().getCamera().clone());
            BufferedImage seen = seen(view, eye);
            ImageIO.write(window, "png", Views.report().resolve("camera-" + example + "-window.png").toFile());
            ImageIO.write(seen, "png", Views.report().resolve("camera-" + example + ".png").toFile());
            return Similarity.of(window, seen);
        }
    }

    /** Hides sensor housings and lights, which beams don't hit. */
    private static void hideWhatIsNoBody(Views view) {
        List<SEARrobot> robots = view.world.simulation.getProject().getRobots();
        for (int i = 0; i < robots.size(); i++) {
            int child = 0;
            for (SearObject part : robots.get(i).getComponents()) {
                if (part instanceof SensorObject || part instanceof Led) {
                    view.scene().world().robot(i).getChild(child).setCullHint(CullHint.Always);
                }
                child += part instanceof Wheel ? 0 : 1;
            }
        }
    }

    private static BufferedImage seen(Views view, Camera camera) throws Exception {
        Vector3f at = camera.getLocation();
        Quaternion turn = camera.getRotation();
        Pose pose = new Pose(at.x, at.y, at.z, turn.getX(), turn.getY(), turn.getZ(), turn.getW());
        double focal = WIDTH * camera.getFrustumNear() / (2 * camera.getFrustumRight());
        BrownLens lens = new BrownLens(focal, (WIDTH - 1) / 2.0, (HEIGHT - 1) / 2.0, new double[4]);
        int[] pixels = view.world.simulation.ask(world -> {
            Truth truth = world.getRobots().get(0).getTruth();
            return new CameraRenderer(WIDTH, HEIGHT, lens, camera.getFrustumNear(), 1e6)
                .colors(new RenderJob(truth.sight(), truth.looks(), pose, BeamScene.WORLD));
        }).get();
        BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(0, 0, WIDTH, HEIGHT, pixels, 0, WIDTH);
        return picture;
    }

    /** Returns a smaller picture whose pixels are the means of the pixels they cover. */
    private static BufferedImage smaller(BufferedImage large) {
        BufferedImage small = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int rgb = 0;
            for (int shift = 16; shift >= 0; shift -= 8) {
                int sum = 0;
                for (int k = 0; k < FINER * FINER; k++) {
                    sum += large.getRGB(i % WIDTH * FINER + k % FINER, i / WIDTH * FINER + k / FINER) >> shift & 0xff;
                }
                rgb |= (sum + FINER * FINER / 2) / (FINER * FINER) << shift;
            }
            small.setRGB(i % WIDTH, i / WIDTH, rgb);
        }
        return small;
    }
}
