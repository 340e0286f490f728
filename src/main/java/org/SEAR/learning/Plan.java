package org.SEAR.learning;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;

/** A world from above, north upwards, east to the right: outlines in the colours of their things, robots with a line ahead. Simulation thread. */
final class Plan {
    private static final double MARGIN = 0.03;
    private static final int PIXEL = 3;
    private static final Color PAPER = new Color(0xf4f4f0);
    private static final Color EDGE = new Color(0, 0, 0, 110);

    private final Simulation simulation;
    private final List<Outline> outlines = new ArrayList<>();
    private double scale;
    private double north;
    private double west;

    /** What is drawn of one thing: {x, z} in the world, in order. */
    private static final class Outline {
        final double[][] points;
        final Color color;
        /** Ground lies below all else. */
        final boolean ground;

        Outline(double[][] points, Color color, boolean ground) {
            this.points = points;
            this.color = color;
            this.ground = ground;
        }
    }

    /** Of the world as it is now. */
    Plan(Simulation simulation) {
        this.simulation = simulation;
        List<SearObject> environment = simulation.getProject().getEnvironment();
        for (int i = 0; i < environment.size(); i++) {
            add(environment.get(i), simulation.snapshot().environment.get(i));
        }
        outlines.sort(Comparator.comparing((Outline one) -> !one.ground));
        for (Robot robot : simulation.getRobots()) {
            for (SearObject part : robot.getObject().getComponents()) {
                add(part, robot.getPose().times(ObjectPose.of(part)));
            }
        }
    }

    private void add(SearObject object, Pose pose) {
        double[][] corners = simulation.getOutline(object);
        if (corners.length < 2 || !(object instanceof Shape)) {
            return;
        }
        double[][] points = new double[corners.length][];
        for (int i = 0; i < corners.length; i++) {
            double[] at = pose.transform(corners[i][0], corners[i][1], corners[i][2]);
            points[i] = new double[] {at[0], at[2]};
        }
        Shape shape = (Shape) object;
        Color color = shape.isGround() && !shape.hasColor() ? Color.WHITE : Color.decode(shape.getColor());
        outlines.add(new Outline(hull(points), color, shape.isGround()));
    }

    /** The convex outline of points. */
    private static double[][] hull(double[][] points) {
        Arrays.sort(points, Comparator.<double[]>comparingDouble(p -> p[0]).thenComparingDouble(p -> p[1]));
        List<double[]> hull = new ArrayList<>();
        for (int pass = 0; pass < 2; pass++) {
            int first = hull.size();
            for (int i = 0; i < points.length; i++) {
                double[] p = points[pass == 0 ? i : points.length - 1 - i];
                while (hull.size() > first + 1 && turn(hull.get(hull.size() - 2), hull.get(hull.size() - 1), p) <= 0) {
                    hull.remove(hull.size() - 1);
                }
                hull.add(p);
            }
            hull.remove(hull.size() - 1);
        }
        return hull.toArray(new double[0][]);
    }

    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /**
     * Draws it.
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
            draw(graphics, outline);
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

    private void draw(Graphics2D graphics, Outline outline) {
        Path2D path = new Path2D.Double();
        for (int i = 0; i < outline.points.length; i++) {
            double x = right(outline.points[i][1]);
            double y = down(outline.points[i][0]);
            if (i == 0) {
                path.moveTo(x, y);
            } else {
                path.lineTo(x, y);
            }
        }
        path.closePath();
        graphics.setColor(outline.color);
        graphics.fill(path);
        graphics.setColor(EDGE);
        graphics.setStroke(new BasicStroke(1));
        graphics.draw(path);
    }

    /** Finds the scale that shows all of it. */
    private void fit(int width, int height) {
        double[] box = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (Outline outline : outlines) {
            for (double[] point : outline.points) {
                box[0] = Math.min(box[0], point[0]);
                box[1] = Math.max(box[1], point[0]);
                box[2] = Math.min(box[2], point[1]);
                box[3] = Math.max(box[3], point[1]);
            }
        }
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
