// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.plot.Canvas;
import org.SEAR.plot.Drawing;

/** Picture of a plan, north up, with a scale and the time. One thread. */
public final class PlanDrawing implements Drawing {
    private static final int WIDTH = 640;
    private static final int TALLEST = 640;
    private static final int LOWEST = 160;
    private static final int MARGIN = 16;
    /** Height below the world for scale and time. */
    private static final int FOOT = 34;
    private static final int SIZE = 12;
    /** Approximate width of a letter, as a fraction of its height. */
    private static final double LETTER = 0.62;
    private static final String PAPER = "#f4f4f0";
    private static final String EDGE = "#888888";
    private static final String INK = "#222222";
    private static final String BEAM = "#d55e00";
    private static final double THIN = 0.15;
    private static final double DOT = 1.5;
    /** Minimum length of a robot's arrow from its centre, points. */
    private static final double ARROW = 13;
    private static final double AHEAD = 1.4;
    /** Angle of the arrow's rear corners. */
    private static final double BACK_ANGLE = Math.toRadians(150);
    private static final double BACK = 0.6;
    private static final double SCALE_BAR = 160;
    private static final double[] STEPS = {5, 2, 1};
    /** More objects than this whose names differ only by numbers, such as maze walls, have no names on the plan. */
    private static final int MAX_ALIKE = 4;
    private static final int SECONDS_A_MINUTE = 60;
    /** Ground this many times larger than everything on it is cropped. */
    private static final double LARGER = 8;
    /** Margin around the objects on cropped ground, as a fraction of their size. */
    private static final double AROUND = 0.25;
    private static final String WHITE = "#ffffff";

    private final Plan plan;
    private final int height;
    private final double scale;
    private final double north;
    private final double west;
    private final List<double[]> taken = new ArrayList<>();

    public PlanDrawing(Plan plan) {
        this.plan = plan;
        double[] box = box();
        double tall = Math.max(box[1] - box[0], 0.1);
        double wide = Math.max(box[3] - box[2], 0.1);
        double room = WIDTH - 2.0 * MARGIN;
        scale = Math.min(room / wide, (TALLEST - 2.0 * MARGIN) / tall);
        double drawn = Math.max(LOWEST, tall * scale + 2 * MARGIN);
        height = (int) Math.ceil(drawn) + FOOT;
        north = (box[0] + box[1]) / 2 + drawn / 2 / scale;
        west = (box[2] + box[3]) / 2 - WIDTH / 2.0 / scale;
    }

    /**
     * Returns the whole world; if the ground is much larger than everything on it, only the area around the objects.
     */
    private double[] box() {
        List<Outline> things = new ArrayList<>(plan.outlines);
        things.removeIf(one -> one.ground);
        double[] all = withRobots(Outline.box(plan.outlines));
        double[] most = things.isEmpty() ? all : withRobots(Outline.box(things));
        double room = AROUND * size(most);
        return size(most) > 0 && size(all) > LARGER * size(most)
            ? new double[] {Math.max(all[0], most[0] - room), Math.min(all[1], most[1] + room),
            Math.max(all[2], most[2] - room), Math.min(all[3], most[3] + room)} : all;
    }

    private static double size(double[] box) {
        return Math.max(box[1] - box[0], box[3] - box[2]);
    }

    private double[] withRobots(double[] given) {
        double[] box = given;
        for (Plan.Mark robot : plan.robots) {
            box = new double[] {Math.min(box[0], robot.x - robot.radius), Math.max(box[1], robot.x + robot.radius),
                Math.min(box[2], robot.z - robot.radius), Math.max(box[3], robot.z + robot.radius)};
        }
        return box;
    }

    @Override
    public int width() {
        return WIDTH;
    }

    @Override
    public int height() {
        return height;
    }

    private double right(double z) {
        return (z - west) * scale;
    }

    private double down(double x) {
        return (north - x) * scale;
    }

    @Override
    public void on(Canvas canvas) {
        taken.clear();
        double foot = height - FOOT;
        area(canvas, new double[][] {{0, 0}, {WIDTH, 0}, {WIDTH, foot}, {0, foot}}, PAPER, 1, PAPER);
        for (Outline outline : plan.outlines) {
            for (double[][] points : outline.areas) {
                double[][] corners = new double[points.length][];
                for (int i = 0; i < corners.length; i++) {
                    corners[i] = new double[] {right(points[i][1]), down(points[i][0])};
                }
                area(canvas, corners, outline.color, 1, EDGE);
            }
        }
        plan.beams.forEach(beams -> draw(canvas, beams, foot));
        plan.robots.forEach(robot -> arrow(canvas, robot));
        plan.robots.forEach(robot -> name(canvas, robot.name + " " + Math.round(robot.heading) + "\u00b0",
            right(robot.z), down(robot.x) + Math.max(ARROW, AHEAD * robot.radius * scale) + SIZE, true));
        names(canvas);
        foot(canvas, foot);
    }

    private static void area(Canvas canvas, double[][] corners, String color, double opacity, String edge) {
        double[] x = new double[corners.length];
        double[] y = new double[corners.length];
        for (int i = 0; i < corners.length; i++) {
            x[i] = corners[i][0];
            y[i] = corners[i][1];
        }
        canvas.area(x, y, color, opacity, edge);
    }

    /** Shortens a beam to the edge of the paper. */
    private double[] inside(double[] from, double[] end, double foot) {
        double[] a = {right(from[1]), down(from[0])};
        double[] b = {right(end[1]), down(end[0])};
        double share = 1;
        double[] most = {WIDTH, foot};
        for (int i = 0; i < 2; i++) {
            double way = b[i] - a[i];
            double room = way > 0 ? most[i] - a[i] : a[i];
            share = Math.abs(way) > room ? Math.min(share, Math.max(0, room / Math.abs(way))) : share;
        }
        return new double[] {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
    }

    private void draw(Canvas canvas, Plan.Beams beams, double foot) {
        List<double[]> corners = new ArrayList<>();
        corners.add(new double[] {right(beams.from[1]), down(beams.from[0])});
        beams.ends.forEach(end -> corners.add(inside(beams.from, end, foot)));
        if (beams.plane && corners.size() > 2) {
            area(canvas, corners.toArray(new double[0][]), BEAM, THIN, BEAM);
        }
        for (int i = 0; i < beams.ends.size(); i++) {
            double[] end = corners.get(i + 1);
            if (!beams.plane) {
                canvas.line(corners.get(0)[0], corners.get(0)[1], end[0], end[1], BEAM, 1);
            }
            if (beams.hits.get(i)) {
                canvas.line(end[0] - DOT, end[1], end[0] + DOT, end[1], BEAM, 2 * DOT);
            }
        }
    }

    private void arrow(Canvas canvas, Plan.Mark robot) {
        double length = Math.max(ARROW, AHEAD * robot.radius * scale);
        double angle = Math.toRadians(robot.heading);
        double[][] corners = new double[4][];
        double[] turns = {0, BACK_ANGLE, 0, -BACK_ANGLE};
        double[] ways = {length, BACK * length, 0, BACK * length};
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new double[] {right(robot.z) + ways[i] * Math.sin(angle + turns[i]),
                down(robot.x) - ways[i] * Math.cos(angle + turns[i])};
        }
        area(canvas, corners, INK, 0.5, INK);
    }

    /** Draws the names of distinguishable objects where there is free space. */
    private void names(Canvas canvas) {
        Map<String, Integer> alike = new HashMap<>();
        plan.outlines.forEach(one -> alike.merge(stem(one.name), 1, Integer::sum));
        for (Outline one : plan.outlines) {
            if (!one.part && !one.ground && alike.get(stem(one.name)) <= MAX_ALIKE) {
                double[] box = Outline.box(List.of(one));
                name(canvas, one.name, right((box[2] + box[3]) / 2), down((box[0] + box[1]) / 2) + SIZE / 3.0, false);
            }
        }
    }

    private static String stem(String name) {
        return name.replaceAll("[\\d\\W_]+", "");
    }

    private void name(Canvas canvas, String text, double x, double y, boolean always) {
        double half = text.length() * SIZE * LETTER / 2;
        double middle = Math.min(Math.max(x, half), WIDTH - half);
        double[] box = {middle - half, y - SIZE, middle + half, y};
        boolean free = taken.stream().noneMatch(one -> box[0] < one[2] && box[2] > one[0] && box[1] < one[3]
            && box[3] > one[1]);
        if (always || free) {
            taken.add(box);
            canvas.label(text, middle, y, Canvas.Anchor.MIDDLE, SIZE);
        }
    }

    private void foot(Canvas canvas, double top) {
        area(canvas, new double[][] {{0, top}, {WIDTH, top}, {WIDTH, height}, {0, height}}, WHITE, 1, WHITE);
        double metres = Math.pow(10, Math.floor(Math.log10(SCALE_BAR / scale)));
        for (double step : STEPS) {
            if (step * metres * scale <= SCALE_BAR) {
                metres *= step;
                break;
            }
        }
        double y = top + FOOT / 2.0;
        double end = MARGIN + metres * scale;
        canvas.line(MARGIN, y, end, y, INK, 2);
        canvas.line(MARGIN, y - SIZE / 3.0, MARGIN, y + SIZE / 3.0, INK, 2);
        canvas.line(end, y - SIZE / 3.0, end, y + SIZE / 3.0, INK, 2);
        String length = metres >= 1 ? String.format(Locale.ROOT, "%.0f m", metres) : metres + " m";
        canvas.text(length, end + SIZE / 2.0, y + SIZE / 3.0, Canvas.Anchor.LEFT, SIZE);
        canvas.text("north is up", WIDTH / 2.0, y + SIZE / 3.0, Canvas.Anchor.MIDDLE, SIZE);
        canvas.text(time(), WIDTH - MARGIN, y + SIZE / 3.0, Canvas.Anchor.RIGHT, SIZE);
    }

    private String time() {
        double rest = plan.time % SECONDS_A_MINUTE;
        long minutes = (long) (plan.time / SECONDS_A_MINUTE);
        return minutes == 0 ? String.format(Locale.ROOT, "after %.2f s", rest)
            : String.format(Locale.ROOT, "after %d min %.2f s", minutes, rest);
    }
}
