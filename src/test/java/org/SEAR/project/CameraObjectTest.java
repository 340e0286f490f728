// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;

import org.SEAR.POJOs.Camera;
import org.junit.Rule;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;

/** Parameters of a camera: models by name, and messages for illegal values. */
public class CameraObjectTest {
    private static final String FOLDS = ", legal: a lens that covers the corners of the picture; these four "
        + "coefficients fold it back before them";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static void refuses(String expected, ThrowingRunnable call) {
        assertEquals(expected, assertThrows(IllegalArgumentException.class, call).getMessage());
    }

    @Test
    public void atFirstItMakesColoursOf320By240() {
        Camera camera = new Camera("eye");
        assertEquals("color 320 x 240, 60.0 degrees, 10.0 Hz", camera.getKind() + " " + camera.getWidth() + " x "
            + camera.getHeight() + ", " + camera.getFieldOfView() + " degrees, " + camera.getRate() + " Hz");
        assertEquals(160 / Math.tan(Math.toRadians(30)), camera.getFocalLength(), 1e-9);
        assertNull(camera.getCx());
        camera.setKind("colour");
        assertEquals(Camera.COLOR, camera.getKind());
    }

    @Test
    public void modelsHaveTheValuesOfTheirDataSheets() {
        Camera camera = new Camera("eye");
        camera.setModel("raspberry pi V2");
        assertEquals("the focal length is 3.04 mm of a sensor of 3.68 mm", 640 * 3.04 / 3.68,
            camera.getFocalLength(), 3);
        camera.setModel("kinect");
        assertEquals(Camera.DEPTH, camera.getKind());
        assertEquals(0.8, camera.getNear(), 0);
        assertEquals("43 degrees up and down", 43, 2 * Math.toDegrees(Math.atan(240 / camera.getFocalLength())), 1.5);
        camera.setModel("d435");
        assertEquals("58 degrees up and down", 58, 2 * Math.toDegrees(Math.atan(240 / camera.getFocalLength())), 2);
        assertEquals("of 0.08 pixels", 0.08 / (camera.getFocalLength() * 0.05), camera.getDepthNoise(), 1e-4);
        camera.setModel("MLX-90640");
        assertEquals(0.1 * Math.sqrt(8), camera.getNetd(), 0.01);
        camera.setModel("Pixy 2");
        assertEquals(0, camera.getNetd(), 0);
        refuses("Camera \"eye\": model is \"GoPro\", legal: RaspberryPi-v2, C270, Kinect, D435, MLX90640, Pixy2",
            () -> camera.setModel("GoPro"));
    }

    @Test
    public void illegalValuesAreReportedWithTheLegalRange() {
        Camera camera = new Camera("eye");
        refuses("Camera \"eye\": kind is \"x-ray\", legal: color, depth, infrared", () -> camera.setKind("x-ray"));
        refuses("Camera \"eye\": width is 0, legal: a whole number from 1 to 2048", () -> camera.setSize(0, 10));
        refuses("Camera \"eye\": 2000 x 2000 are 4000000 pixels, legal: at most 2073600 (1920 x 1080)",
            () -> camera.setSize(2000, 2000));
        refuses("Camera \"eye\": fieldOfView is 180, legal: a number from 0.1 to 170 deg",
            () -> camera.setFieldOfView(180));
        refuses("Camera \"eye\": rate is 100, legal: a number from 0.001 to 60 Hz", () -> camera.setRate(100));
        refuses("Camera \"eye\": near is 5, legal: less than far, 4 m", () -> camera.setRange(5, 4));
        refuses("Camera \"eye\": readNoise is 5, legal: 0 without fullWell, the electrons of a white pixel",
            () -> camera.setShotNoise(0, 5));
        assertEquals("nothing has changed", 320, camera.getWidth());
    }

    @Test
    public void aLensThatFoldsItsPictureIsRefused() {
        Camera camera = new Camera("eye");
        refuses("Camera \"eye\": k1 is -3" + FOLDS, () -> camera.setLens(-3, 0, 0, 0));
        assertEquals(0, camera.getK1(), 0);
        camera.setLens(-0.3, 0.02, 0, 0);
        refuses("Camera \"eye\": k1 is -0.3" + FOLDS, () -> camera.setFieldOfView(150));
        refuses("Camera \"eye\": k1 is -0.3" + FOLDS, () -> camera.setCentre(-2000.0, null));
        refuses("Camera \"eye\": k1 is -0.3" + FOLDS, () -> camera.setSize(10, 2000));
        assertEquals("320 x 240 60.0 null", camera.getWidth() + " x " + camera.getHeight() + " "
            + camera.getFieldOfView() + " " + camera.getCx());
    }
}
