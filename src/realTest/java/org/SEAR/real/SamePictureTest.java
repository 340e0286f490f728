// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.SEAR.web.MyRobotLab;
import org.junit.Test;

/**
 * The embedded MyRobotLab shows SEAR's panel as the real one does: every part at the same place, and nearly the same
 * pixels.
 */
public class SamePictureTest extends InRealMrl {
    private static final int[][] SIZES = {{800, 1000}, {1024, 768}, {1366, 768}, {1920, 1080}};
    private static final String PROJECT = "sear.loadProject(" + RealMrl.literal(ROOT + "/examples/office.sear") + ")";
    /** Tolerance of positions and sizes, pixels. */
    private static final double NEAR = 2;
    /** Sum of the differences of red, green and blue from which two pixels count as different. */
    private static final int DIFFERENT = 60;
    /** Largest share of different pixels. The embedded page's buttons and grey text are darker for legibility. */
    private static final double MOST_DIFFERENT = 0.015;
    private static final String PREPARE = "if (!document.querySelector('.sear-save')) { "
        + "document.querySelector('.sear-fold-project').click() }";
    private static final String READY =
        "world.preview !== null && edits.grammar !== null && world.shown() && world.shown().robots.length == 1 "
        + "&& view.fitted";
    /** Script that returns type, left, top, width and height of each visible part of the panel, in window pixels. */
    private static final String BOXES = String.join("\n",
        "return [].filter.call(document.querySelectorAll('.sear-main, .sear-main *'), function(e) {",
        "    return e.getClientRects().length && !e.closest('option')",
        "}).map(function(e) {",
        "    var box = e.getBoundingClientRect()",
        "    return {name: e.tagName + ' ' + e.className.replace(/ ?\\bng-\\S+/g, ''), box: [box.left, box.top, "
        + "box.width, box.height]}",
        "})");

    @Test
    public void everyPartIsAtTheSamePlaceAndPixelsAreTheSame() throws Exception {
        assertEquals("", mrl.python("sear = Runtime.start('sear', 'SEAR')", PROJECT));
        try (MyRobotLab embedded = new MyRobotLab("sear = Runtime.start('sear', 'SEAR')\n" + PROJECT); Page page =
            new Page()) {
            View[] real = new View[SIZES.length];
            page.open(mrl, "sear");
            for (int i = 0; i < SIZES.length; i++) {
                real[i] = new View(page, "real", SIZES[i]);
            }
            page.browser.driver().get(embedded.url() + "?layout=myrobotlab#/sear");
            for (int i = 0; i < SIZES.length; i++) {
                real[i].checkSame(new View(page, "embedded", SIZES[i]));
            }
        }
    }

    /** Parts and picture of the page at one window size. */
    private static final class View {
        private final String size;
        private final List<Map<String, Object>> parts;
        private final BufferedImage picture;

        @SuppressWarnings("unchecked")
        View(Page page, String where, int[] wanted) throws IOException {
            size = wanted[0] + " x " + wanted[1];
            page.setSize(wanted[0], wanted[1]);
            page.browser.see(Page.SEAR);
            page.browser.script(PREPARE);
            page.await("the project", READY);
            page.browser.script("angular.element(document.querySelector('.sear-main')).scope().$apply('view.fit()')");
            page.browser.until("a drawn frame", () -> Boolean.TRUE.equals(page.browser.driver().executeAsyncScript(
                "var done = arguments[0]; requestAnimationFrame(function() { requestAnimationFrame(function() { "
                    + "done(true) }) })")));
            parts = (List<Map<String, Object>>) page.browser.script(BOXES);
            Path file = page.keep("panel-" + where + "-" + wanted[0]);
            picture = ImageIO.read(Files.newInputStream(file));
        }

        private double[] box(int part) {
            return ((List<?>) parts.get(part).get("box")).stream()
                .mapToDouble(number -> ((Number) number).doubleValue()).toArray();
        }

        private Object name(int part) {
            return parts.get(part).get("name");
        }

        void checkSame(View other) {
            assertEquals(size, parts.size(), other.parts.size());
            for (int i = 0; i < parts.size(); i++) {
                assertEquals(size, name(i), other.name(i));
                assertTrue(size + ", " + name(i) + ": " + List.of(parts.get(i), other.parts.get(i)),
                    isNear(box(i), other.box(i)));
            }
            checkPixels(other);
        }

        private static boolean isNear(double[] one, double[] other) {
            for (int i = 0; i < one.length; i++) {
                if (Math.abs(one[i] - other[i]) > NEAR) {
                    return false;
                }
            }
            return true;
        }

        private void checkPixels(View other) {
            double[] box = box(0);
            int right = Math.min(picture.getWidth(), (int) (box[0] + box[2]));
            int bottom = Math.min(picture.getHeight() - 16, (int) (box[1] + box[3]));
            int different = 0;
            int all = 0;
            for (int y = (int) box[1]; y < bottom; y++) {
                for (int x = (int) box[0]; x < right; x++) {
                    different += distance(picture.getRGB(x, y), other.picture.getRGB(x, y)) > DIFFERENT ? 1 : 0;
                    all++;
                }
            }
            assertTrue(size + ": " + different + " of " + all + " pixels are different",
                different < MOST_DIFFERENT * all);
        }

        private static int distance(int one, int other) {
            int sum = 0;
            for (int shift = 0; shift <= 16; shift += 8) {
                sum += Math.abs((one >> shift & 255) - (other >> shift & 255));
            }
            return sum;
        }
    }
}
