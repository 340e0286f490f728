// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.jme3.collision.CollisionResults;
import com.jme3.math.FastMath;
import com.jme3.math.Ray;
import com.jme3.math.Vector3f;
import com.jme3.scene.Node;
import java.awt.Color;
import java.awt.image.BufferedImage;
import org.junit.Test;
import org.junit.runner.RunWith;

/** The example projects in the window: known objects have their colours at their places. */
@RunWith(UnderXvfb.class)
public class ExamplesTest {
    private static final float ORANGE = 0.055f;
    private static final float BROWN = 0.09f;
    private static final float BRICK = 0.02f;
    private static final float BLUE = 0.6f;
    private static final float RED = 0.01f;
    private static final float TEAL = 0.5f;
    private static final float HUE_OFF = 0.075f;
    private static final float SATURATED = 0.2f;
    private static final float AWAY = 1.1f;
    private static final float DOWN = 0.35f;
    private static final int DIRECTIONS = 12;

    private static void shows(String example, Object... objectsAndHues) throws Exception {
        try (Views view = new Views(Examples.folder(example), new WindowOptions().setSize(640, 400))) {
            view.press("F2");
            for (int i = 0; i < objectsAndHues.length; i += 2) {
                String name = (String) objectsAndHues[i];
                view.ask(() -> {
                    lookAt(view, name);
                    return null;
                });
                BufferedImage picture = view.picture(example + "-" + name.replace(' ', '-'));
                assertHue(example + ": " + name, (Float) objectsAndHues[i + 1], Colors.mean(picture, 320, 200));
            }
            assertEquals(0, view.warnings.size());
        }
    }

    private static void assertHue(String what, float wanted, Color color) {
        float[] seen = Color.RGBtoHSB(color.getRed(), color.getGreen(), color.getBlue(), null);
        float off = Math.abs(seen[0] - wanted);
        assertTrue(what + " is " + color + ", hue " + seen[0], Math.min(off, 1 - off) < HUE_OFF && seen[1] > SATURATED);
    }

    /** Moves the flycam to a place with a free view of the object's middle. */
    private static void lookAt(Views view, String name) {
        Node object = (Node) view.scene().world().root().getChild(name);
        Vector3f middle = object.getWorldBound().getCenter();
        for (int i = 0; i < DIRECTIONS; i++) {
            float yaw = FastMath.TWO_PI * i / DIRECTIONS;
            Vector3f ahead = new Vector3f(FastMath.sin(yaw) * FastMath.cos(DOWN), -FastMath.sin(DOWN),
                FastMath.cos(yaw) * FastMath.cos(DOWN));
            Vector3f place = middle.subtract(ahead.mult(AWAY));
            CollisionResults hits = new CollisionResults();
            for (Node other : view.scene().world().environment()) {
                other.collideWith(new Ray(place, ahead), hits);
            }
            if (hits.size() > 0 && hits.getClosestCollision().getGeometry().hasAncestor(object)
                    && hits.getClosestCollision().getDistance() > AWAY / 4) {
                view.scene().camera().fly(place, yaw, DOWN);
                return;
            }
        }
        throw new AssertionError(name + " can't be seen from anywhere");
    }

    @Test
    public void office() throws Exception {
        shows("office", "trash Can", BLUE, "wet floor", ORANGE, "parcel 3", BROWN, "partition", TEAL);
    }

    @Test
    public void maze() throws Exception {
        shows("maze", "goal", ORANGE, "wall 01", BRICK);
    }

    @Test
    public void ramps() throws Exception {
        shows("ramps", "high plateau", RED, "step 3", BRICK);
    }

    @Test
    public void sensors() throws Exception {
        shows("sensors", "recycling bin", BLUE, "crate 5", BROWN, "cone 3", ORANGE);
    }
}
