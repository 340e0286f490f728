// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.jme3.renderer.Statistics;
import com.jme3.scene.Node;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import org.junit.Test;
import org.junit.runner.RunWith;

/** The sun's shadows and their drawing cost, in counts instead of times. */
@RunWith(UnderXvfb.class)
public class ShadowsTest {
    private static final int PICTURES = 12;
    /**
     * Limit of vertices per picture: two thirds of the cost of drawing shadows for the office without a lookup per
     * surface.
     */
    private static final int FEW_VERTICES = 14_000;
    private static final double SHADED_LOW = 0.5;
    private static final double SHADED_HIGH = 0.62;
    private static final double SAME = 0.97;

    private static Views office() throws Exception {
        Views view = new Views(Examples.folder("office"), new WindowOptions().setSize(640, 400));
        view.ask(() -> {
            view.app().getRenderer().getStatistics().setEnabled(true);
            return null;
        });
        return view;
    }

    /** Returns a statistic of the last picture. */
    private static int count(Views view, String what) throws Exception {
        view.frames(3);
        return view.ask(() -> {
            Statistics statistics = view.app().getRenderer().getStatistics();
            int[] counts = new int[statistics.getLabels().length];
            statistics.getData(counts);
            return counts[Arrays.asList(statistics.getLabels()).indexOf(what)];
        });
    }

    private static void setShadows(Views view, boolean on) throws Exception {
        view.ask(() -> {
            view.scene().lighting().setShadows(on);
            return null;
        });
        view.frames(3);
    }

    private static int draws(Views view) throws Exception {
        return view.ask(() -> view.scene().lighting().shadowDraws());
    }

    private static int brightness(int rgb) {
        return (rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255);
    }

    @Test
    public void shadowsOfStillObjectsCostNoDrawing() throws Exception {
        try (Views view = office()) {
            view.world.runner.setPaused(true);
            view.frames(PICTURES);
            int before = draws(view);
            assertTrue("things cast shadows: " + before, before > 20);
            view.frames(PICTURES);
            assertEquals("nothing has moved", before, draws(view));
            int objects = count(view, "Objects");
            int vertices = count(view, "Vertices");
            setShadows(view, false);
            assertEquals("each surface is drawn once, shadows or not", count(view, "Objects"), objects);
            assertTrue("vertices: " + vertices, vertices < FEW_VERTICES);
        }
    }

    @Test
    public void movingObjectsRedrawTheirShadow() throws Exception {
        try (Views view = office()) {
            view.world.runner.setPaused(true);
            view.frames(PICTURES);
            int before = draws(view);
            Node can = view.ask(() -> (Node) view.scene().world().root().getChild("trash Can"));
            view.ask(() -> {
                can.getChild(0).move(0, 2, 0); // the simulation sets the pose of the node itself
                return null;
            });
            Views.until("it is drawn for its shadow",
                () -> view.is(() -> view.scene().lighting().shadowDraws() > before));
            view.frames(PICTURES);
            int drawn = draws(view);
            view.frames(PICTURES);
            assertEquals("and then no more", drawn, draws(view));
        }
    }

    @Test
    public void shadowsRemoveTheSunsLightEvenOnSlowMachines() throws Exception {
        try (Views view = office()) {
            view.world.runner.setPaused(true);
            view.press("F2");
            view.ask(() -> {
                view.scene().lighting().hurryShadows();
                return null;
            });
            assertTrue(view.is(() -> view.scene().lighting().hasShadows()));
            BufferedImage with = view.picture("shadows");
            setShadows(view, false);
            BufferedImage without = view.picture("no-shadows");
            int shaded = 0;
            int same = 0;
            int floor = 0;
            for (int y = with.getHeight() / 3; y < with.getHeight() * 4 / 5; y++) {
                for (int x = with.getWidth() / 8; x < with.getWidth() * 7 / 8; x++) {
                    double ratio = (double) brightness(with.getRGB(x, y)) / Math.max(
                        1, brightness(without.getRGB(x, y)));
                    floor++;
                    shaded += ratio > SHADED_LOW && ratio < SHADED_HIGH ? 1 : 0;
                    same += ratio > SAME ? 1 : 0;
                }
            }
            assertTrue(shaded + " of " + floor + " lie in a shadow", shaded > floor / 100);
            assertTrue(same + " of " + floor + " lie in the sun", same > floor / 2);
            assertTrue(shaded + " and " + same + " of " + floor + ": all but the shadows' edges",
                shaded + same > floor * 9 / 10);
        }
    }
}
