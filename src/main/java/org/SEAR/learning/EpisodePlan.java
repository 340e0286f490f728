// SPDX-License-Identifier: Apache-2.0
package org.SEAR.learning;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.SEAR.geometry.Pose;
import org.SEAR.plan.Outline;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;

/**
 * Picture of a world from above, north up, east to the right: coloured outlines, and robots with a line ahead.
 * Simulation thread.
 */
final class EpisodePlan {
    private static final double MARGIN = 0.03;
    private static final int PIXEL = 3;
    private static final Color PAPER = new Color(0xf4f4f0);
    private static final Color EDGE = new Color(0, 0, 0, 110);

    private final Simulation simulation;
    private final List<Outline> outlines;
    private double scale;
    private double north;
    private double west;

    /** Plan of the current world. */
    EpisodePlan(Simulation simulation) {
        this.simulation = simulation;
        outlines = Outline.of(simulation);
    }

    /**
     * Draws the plan.
     *
     * @param width pixels, 16 to 4096, likewise height
     * @return red, green, blue of each pixel, row by row from the top left
     */
    byte[] draw(int width, int height) {
        if (Math.min(width, height) < 16 || Math.max(width, height) > 4096) {
            throw new IllegalArgumentException("picture is " + width + " x " + height + " pixels, legal: 16 to 4096");
        }
        fit(width, height);
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        graphics.setColor(PAPER);
        graphics.fillRect(0, 0, width, height);
        for (Outline outline : outlines) {
            for (double[][] area : outline.areas) {
                draw(graphics, area, outline.color);
            }
        }
        graphics.setStroke(new BasicStroke(2));
        graphics.setColor(Color.BLACK);
        for (Robot robot : simulation.getRobots()) {
            double length = Math.max(robot.getHardware().getBodyRadius(), 6 / scale);
            Pose pose = robot.getPose();
            double[] ahead = pose.transform(0, 0, 1.4 * length);
            graphics.draw(new Line2D.Double(right(pose.z), down(pose.x), right(ahead[2]), down(ahead[0])));
        }
        graphics.dispose();
        return bytes(picture.getRGB(0, 0, width, height, null, 0, width));
    }

    private void draw(Graphics2D graphics, double[][] points, String color) {
        Path2D path = new Path2D.Double();
        for (int i = 0; i < points.length; i++) {
            double x = right(points[i][1]);
            double y = down(points[i][0]);
            if (i == 0) {
                path.moveTo(x, y);
            } else {
                path.lineTo(x, y);
            }
        }
        path.closePath();
        graphics.setColor(Color.decode(color));
        graphics.fill(path);
        graphics.setColor(EDGE);
        graphics.setStroke(new BasicStroke(1));
        graphics.draw(path);
    }

    /** Computes the scale and the corner that show the whole world. */
    private void fit(int width, int height) {
        double[] box = Outline.box(outlines);
        double tall = Math.max(box[1] - box[0], 0.1);
        double wide = Math.max(box[3] - box[2], 0.1);
        scale = (1 - 2 * MARGIN) * Math.min(height / tall, width / wide);
        north = (box[0] + box[1]) / 2 + height / scale / 2;
        west = (box[2] + box[3]) / 2 - width / scale / 2;
    }

    private double right(double z) {
        return (z - west) * scale;
    }

    private double down(double x) {
        return (north - x) * scale;
    }

    private static byte[] bytes(int[] pixels) {
        byte[] bytes = new byte[PIXEL * pixels.length];
        for (int i = 0; i < pixels.length; i++) {
            bytes[PIXEL * i] = (byte) (pixels[i] >> 16);
            bytes[PIXEL * i + 1] = (byte) (pixels[i] >> 8);
            bytes[PIXEL * i + 2] = (byte) pixels[i];
        }
        return bytes;
    }
}
