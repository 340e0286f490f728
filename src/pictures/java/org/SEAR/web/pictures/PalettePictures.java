// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.SearTab;

/**
 * Takes the palette's pictures: each object as the view draws it, without ground and sky, all in one file in the order
 * of {@code kinds.js}.
 */
final class PalettePictures {
    private static final Path FILE = Paths.get("resources/resource/WebGui/app/service/js/sear/tiles/palette.png");
    private static final Path SCRIPT = Paths.get("src/test/resources/pictures/palette.py");
    /** Size of a picture, and its margin, pixels. */
    private static final int CELL = 64;
    private static final int MARGIN = 2;
    /** Name of the only object to draw, for projects with other objects. */
    private static final Map<String, String> ONLY = Map.of("Model", "plant", "Terrain", "none");
    /** Draws the shown world as a large picture without a background. */
    private static final String DRAW = String.join("\n",
        "var view = angular.element(document.querySelector('.sear-main')).scope().view, s = view.scene(), only = "
        + "arguments[0]", "s.objects.forEach(item => item.holder.visible = only ? item.source.name === only : "
        + "item.source.name.indexOf('hidden') !== 0)", "s.robots.forEach(item => item.holder.visible = !only)",
        "s.sensors.forEach(item => item.holder.visible = !only)",
        "s.showGrid(false)",
        "s.orbit.distance *= only === 'none' ? 4 : 1.5; s.orbit.azimuth = Math.PI * 0.8; s.orbit.elevation = only === "
        + "'none' ? 0.7 : 0.5", "s.sun.castShadow = false",
        "s.scene.traverse(one => {",
        "    one.receiveShadow = false",
        "    if (one.material) { one.material.needsUpdate = true }",
        "})",
        "s.aim(-1); s.shade()",
        "s.camera.aspect = 1; s.camera.fov = 25; s.orbit.distance *= 2; s.aim(-1)",
        "s.camera.aspect = 1; s.camera.updateProjectionMatrix()",
        "s.renderer.setPixelRatio(1); s.renderer.setSize(1200, 1200, false); s.size = ''",
        "s.renderer.render(s.scene, s.camera)",
        "return s.canvas.toDataURL('image/png')");

    private PalettePictures() {
    }

    static void take() throws Exception {
        try (Browser browser = new Browser(1000, 800); MyRobotLab robotLab =
            new MyRobotLab("sear = Runtime.start('sear', 'SEAR')")) {
            browser.driver().get(robotLab.url() + "#/sear");
            browser.see(SearTab.ROOT);
            browser.script("localStorage.setItem('sear.view', 'space')");
            browser.driver().navigate().refresh();
            browser.see(SearTab.ROOT);
            robotLab.run(Files.readString(SCRIPT));
            List<?> kinds = (List<?>) browser.module("build/kinds.js", "return module.PICTURED");
            int columns = ((Number) browser.module("build/kinds.js", "return module.COLUMNS")).intValue();
            int rows = (kinds.size() + columns - 1) / columns;
            BufferedImage all = new BufferedImage(columns * CELL, rows * CELL, BufferedImage.TYPE_INT_ARGB);
            for (int i = 0; i < kinds.size(); i++) {
                Graphics2D pen = all.createGraphics();
                pen.drawImage(take(browser, robotLab, (String) kinds.get(i)), i % columns * CELL,
                    i / columns * CELL, null);
                pen.dispose();
            }
            ImageIO.write(all, "png", FILE.toFile());
            System.out.println(FILE + ", " + Files.size(FILE) + " bytes");
        }
    }

    private static BufferedImage take(Browser browser, MyRobotLab robotLab, String kind) throws IOException {
        Object edit = browser.module("build/things.js", "return module.isThing('" + kind
            + "') ? JSON.stringify(module.thingEdit('" + kind + "', [0, 0, 0], [], Number)) : ''");
        robotLab.run("draw('" + kind + "', '" + edit + "')");
        String stamp = robotLab.call("sear", "getPreview", "").get("stamp").asText();
        browser.until(kind, () -> Boolean.TRUE.equals(
            browser.scope(SearTab.ROOT, "world.preview && world.preview.stamp === '" + stamp + "'"
            + " && view.scene() !== null")));
        browser.script("angular.element(document.querySelector('.sear-main')).scope().view.fit()");
        browser.until("what " + kind + " looks like",
            () -> Boolean.TRUE.equals(browser.script("var scope = angular.element("
            + "document.querySelector('.sear-main')).scope();var s = scope.view.scene(), now = scope.world.shown();"
            + "return scope.view.fitted && Object.keys(s.looks.wanted).length === 0 && s.objects.length === "
            + "now.objects.length"
            + " && s.objects.every((item, i) => item.source === now.objects[i] && item.dressed && item.shown "
            + "=== item.to)"
            + " && s.robots.every(robot => robot.parts.every(item => item.dressed && item.shown === item.to))"
            + " && (now.objects.every(one => !one.ground) || s.ground !== null)")));
        String url = (String) browser.script(DRAW, ONLY.get(kind));
        byte[] png = Base64.getDecoder()
            .decode(url.substring(url.indexOf(',') + 1).getBytes(StandardCharsets.US_ASCII));
        return small(ImageIO.read(new ByteArrayInputStream(png)), kind);
    }

    /** Crops to the drawn part and scales it to fit. */
    private static BufferedImage small(BufferedImage large, String kind) {
        Rectangle part = null;
        for (int y = 0; y < large.getHeight(); y++) {
            for (int x = 0; x < large.getWidth(); x++) {
                if (large.getRGB(x, y) >>> 24 > 8) {
                    Rectangle one = new Rectangle(x, y, 1, 1);
                    part = part == null ? one : part.union(one);
                }
            }
        }
        if (part == null) {
            throw new IllegalStateException("nothing is seen of " + kind);
        }
        BufferedImage picture = new BufferedImage(large.getWidth(), large.getHeight(), BufferedImage.TYPE_INT_ARGB_PRE);
        picture.createGraphics().drawImage(large, 0, 0, null);
        picture = picture.getSubimage(part.x, part.y, part.width, part.height);
        double scale = (CELL - 2.0 * MARGIN) / Math.max(part.width, part.height);
        while (scale < 0.5) {       // by halves, so that every pixel counts
            picture = scaled(picture, 0.5);
            scale *= 2;
        }
        picture = scaled(picture, scale);
        BufferedImage cell = new BufferedImage(CELL, CELL, BufferedImage.TYPE_INT_ARGB);
        cell.createGraphics().drawImage(picture, (CELL - picture.getWidth()) / 2,
            (CELL - picture.getHeight()) / 2, null);
        return cell;
    }

    private static BufferedImage scaled(BufferedImage picture, double scale) {
        int width = Math.max(1, (int) Math.round(picture.getWidth() * scale));
        int height = Math.max(1, (int) Math.round(picture.getHeight() * scale));
        BufferedImage smaller = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB_PRE);
        Graphics2D pen = smaller.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        pen.drawImage(picture, 0, 0, width, height, null);
        pen.dispose();
        return smaller;
    }
}
