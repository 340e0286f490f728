// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.TextLayout;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;

/** Canvas for a PNG file, with the computer's fonts. One thread. */
final class PngCanvas implements Canvas {
    private static final int OPAQUE = 255;
    private static final double RIM = 3;

    private final BufferedImage picture;
    private final Graphics2D graphics;

    PngCanvas(int width, int height) {
        picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        graphics = picture.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, width, height);
    }

    private void pen(String color, double width) {
        graphics.setColor(Color.decode(color));
        graphics.setStroke(new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND));
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, String color, double width) {
        pen(color, width);
        graphics.draw(new Line2D.Double(x1, y1, x2, y2));
    }

    @Override
    public void polyline(double[] x, double[] y, int count, String color, double width) {
        pen(color, width);
        Path2D path = new Path2D.Double();
        path.moveTo(x[0], y[0]);
        for (int i = 1; i < count; i++) {
            path.lineTo(x[i], y[i]);
        }
        graphics.draw(path);
    }

    @Override
    public void area(double[] x, double[] y, String color, double opacity, String edge) {
        Path2D path = new Path2D.Double();
        path.moveTo(x[0], y[0]);
        for (int i = 1; i < x.length; i++) {
            path.lineTo(x[i], y[i]);
        }
        path.closePath();
        Color fill = Color.decode(color);
        graphics.setColor(new Color(fill.getRed(), fill.getGreen(), fill.getBlue(),
            (int) Math.round(opacity * OPAQUE)));
        graphics.fill(path);
        pen(edge, 1);
        graphics.draw(path);
    }

    @Override
    public void text(String text, double x, double y, Anchor anchor, int size) {
        double left = left(text, x, anchor, size);
        graphics.setColor(Color.BLACK);
        graphics.drawString(text, (float) left, (float) y);
    }

    /** Selects the font size and returns the left end of a text. */
    private double left(String text, double x, Anchor anchor, int size) {
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, size));
        double width = graphics.getFontMetrics().stringWidth(text);
        return anchor == Anchor.LEFT ? x : anchor == Anchor.RIGHT ? x - width : x - width / 2;
    }

    @Override
    public void label(String text, double x, double y, Anchor anchor, int size) {
        double left = left(text, x, anchor, size);
        if (!text.isEmpty()) {
            pen("#ffffff", RIM);
            graphics.draw(new TextLayout(text, graphics.getFont(), graphics.getFontRenderContext())
                .getOutline(AffineTransform.getTranslateInstance(left, y)));
        }
        text(text, x, y, anchor, size);
    }

    @Override
    public void upwards(String text, double x, double y, int size) {
        AffineTransform before = graphics.getTransform();
        graphics.translate(x, y);
        graphics.rotate(-Math.PI / 2);
        text(text, 0, 0, Anchor.MIDDLE, size);
        graphics.setTransform(before);
    }

    /** Returns the complete file. */
    byte[] file() throws IOException {
        graphics.dispose();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(picture, "png", bytes);
        return bytes.toByteArray();
    }
}
