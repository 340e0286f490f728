// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.jme3.math.Vector3f;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.VertexBuffer;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.FloatBuffer;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;

/** Content of the window: known objects in their colours at their places. */
@RunWith(UnderXvfb.class)
public class PictureTest {
    private static final float HIGH = 0.35f;
    private Views view;

    @Before
    public void open() throws Exception {
        view = new Views(ViewProjects.room(), new WindowOptions().setSize(900, 600));
    }

    @After
    public void close() {
        view.close();
    }

    private Color at(BufferedImage picture, double x, double y, double z) throws Exception {
        Vector3f pixel = view.ask(() -> view.app().getCamera()
            .getScreenCoordinates(new Vector3f((float) x, (float) y, (float) z)));
        return Colors.around(picture, Math.round(pixel.x), Math.round(picture.getHeight() - 1 - pixel.y));
    }

    private void assertHue(String what, float wanted, Color color) {
        float[] hsb = Color.RGBtoHSB(color.getRed(), color.getGreen(), color.getBlue(), null);
        float off = Math.abs(hsb[0] - wanted);
        assertTrue(what + " is " + color, Math.min(off, 1 - off) < 0.06 && hsb[1] > 0.5);
    }

    @Test
    public void boxesCylinderConeSphereAndModelStandWhereTheyAreInTheirPictures() throws Exception {
        view.press("F2");
        view.ask(() -> {
            view.scene().camera().fly(new Vector3f(0, 2.5f, -1.5f), 0, HIGH);
            return null;
        });
        BufferedImage picture = view.picture("room");
        assertHue("RedBox", 0, at(picture, 2, 0.25, 1.95));
        assertHue("GreenBox", 1 / 3f, at(picture, 0, 0.25, 2.35));
        assertHue("BlueBox", 2 / 3f, at(picture, -2, 0.25, 1.95));
        assertHue("Drum", 0.153f, at(picture, 1, 0.5, 3.15));
        assertHue("Spike", 0, at(picture, -1, 0.2, 3.2));
        assertHue("Egg", 1 / 3f, at(picture, 2, 0.6, 3.2));
        assertHue("Plain, without a picture, is orange", 0.108f, at(picture, 1, 0.1, 1.39));
        Color ball = at(picture, -1, 0.12, 1.41);
        assertTrue("a ball without picture and colour is violet: " + ball, ball.getRed() > ball.getGreen() + 20
            && ball.getBlue() > ball.getRed());
        Color floor = at(picture, 0, 0, 1);
        assertTrue("the floor is grey: " + floor, Math.abs(floor.getRed() - floor.getBlue()) < 30);
    }

    @Test
    public void aFloorsPictureIsRepeatedAfterSoManyMetres() throws Exception {
        Geometry floor = view.ask(() -> (Geometry) ((Node) view.scene().world().root().getChild("Floor")).getChild(0));
        FloatBuffer places = floor.getMesh().getFloatBuffer(VertexBuffer.Type.TexCoord);
        float least = Float.POSITIVE_INFINITY;
        float most = Float.NEGATIVE_INFINITY;
        for (int i = 0; i < places.limit(); i += 2) {
            least = Math.min(least, places.get(i));
            most = Math.max(most, places.get(i));
        }
        assertEquals("16 m of 0.5 m each", 32, most - least, 1e-3);
    }

    @Test
    public void theSkyIsBlueAndTheWindowIsNotEmpty() throws Exception {
        view.ask(() -> {
            view.scene().camera().fly(new Vector3f(0, 1, 0), 0, -1);
            return null;
        });
        Color sky = Colors.around(view.picture("sky"), 600, 200);
        assertTrue(sky.toString(), sky.getBlue() > sky.getRed() + 30);
    }

    @Test
    public void theHorizonIsALineBetweenSkyAndLand() throws Exception {
        view.ask(() -> {
            view.scene().camera().fly(new Vector3f(0, 30, 20), 0, 0);
            return null;
        });
        BufferedImage picture = view.picture("horizon");
        Color sky = Colors.around(picture, 450, 290);
        Color land = Colors.around(picture, 450, 310);
        assertTrue("sky: " + sky, sky.getBlue() > sky.getRed());
        assertTrue("land: " + land, land.getGreen() > land.getBlue() && sky.getBlue() > land.getBlue() + 20);
    }

    @Test
    public void aLidarsHitsLieOnTheBoxesItMeets() throws Exception {
        view.press("2", "F5");
        view.ask(() -> {
            view.scene().camera().fly(new Vector3f(0, 3, 1), 0, 1.1f);
            return null;
        });
        Views.until("the LIDAR measures", () -> view.is(() -> view.scene().world().beams().get(0).hitCount() > 30));
        BufferedImage picture = view.picture("lidar-hits");
        double height = view.world.robot().pose.y + 0.15;
        Color hit = at(picture, view.world.robot().pose.x, height, 2.345);
        assertHue("a hit of the LIDAR on GreenBox", 0.155f, hit);
    }

    @Test
    public void aDistanceSensorShowsARedBallWhereItMeasures() throws Exception {
        Views.until("it measures", () -> view.is(() -> view.scene().world().beams().get(1).hitCount() == 1));
        assertEquals(1, (int) view.ask(() -> view.scene().world().beams().get(1).hitCount()));
        String label = view.ask(() -> view.scene().labels().text("Ping1"));
        assertTrue(label, label.matches("Ping1  \\d\\.\\d\\d\\d m"));
    }

    @Test
    public void wheelsTurnWithTheWay() throws Exception {
        Vector3f before = spoke();
        view.press("u");
        Views.until("the wheel has turned", () -> angle(before) > 0.3);
        view.press("semicolon");
    }

    private Vector3f spoke() throws Exception {
        return view.ask(() -> view.scene().world().wheel(0, 0).getLocalRotation().mult(Vector3f.UNIT_Z));
    }

    private float angle(Vector3f before) {
        try {
            return spoke().angleBetween(before);
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    @Test
    public void thePanelShowsNumbersOfTheSimulation() throws Exception {
        Views.until("all sensors are listed",
            () -> view.is(() -> view.scene().hud().statusText().contains("Odometer1: ")));
        String text = view.ask(() -> view.scene().hud().statusText());
        for (String part : new String[] {"time ", " of 1", "Roomba1   x ", "heading 90 deg", "m/s",
            "1  LIDAR1: nearest ", "2  Ping1: ", "GPS1: 35.2", "Compass1: ", "Accel1: ", "Gyro1: "}) {
            assertTrue(part + " in " + text, text.contains(part));
        }
    }
}
