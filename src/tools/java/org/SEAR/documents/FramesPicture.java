// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import java.util.Locale;

/** Frames of world and robot as SVG: axes, heading and rotation, from above. */
final class FramesPicture {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 420;
    private static final double ROBOT = 34;
    /** Heading of the robot in the picture, degrees. */
    private static final double HEADING = 35;
    private static final String WORLD = "#1f5fa8";
    private static final String BODY = "#b3420e";
    private static final String GREY = "#666";

    private final StringBuilder out = new StringBuilder();

    private FramesPicture() {
    }

    static String svg() {
        FramesPicture picture = new FramesPicture();
        picture.out.append(format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" "
            + "font-family=\"sans-serif\" font-size=\"14\">%n", WIDTH, HEIGHT));
        picture.out.append("<title>The frames of the world and of a robot, seen from above</title>\n<defs>");
        for (String color : new String[] {WORLD, BODY, GREY}) {
            picture.out.append(format("<marker id=\"%s\" markerWidth=\"9\" markerHeight=\"9\" refX=\"7\" refY=\"4\" "
                + "orient=\"auto\"><path d=\"M0,0 L8,4 L0,8 z\" fill=\"%s\"/></marker>", marker(color), color));
        }
        picture.out.append("</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
        picture.world(90, 350);
        picture.body(690, 240);
        return picture.out.append("</svg>\n").toString();
    }

    private void world(double x, double y) {
        title(40, "The world, from above");
        arrow(x, y, x, 60, WORLD);
        text(x + 10, 66, WORLD, "+x north");
        arrow(x, y, 430, y, WORLD);
        text(380, y - 10, WORLD, "+z east");
        upwards(x, y, WORLD);
        text(x - 62, y + 24, WORLD, "+y up");
        double robotX = 250;
        double robotY = 230;
        dashed(robotX, y, robotX, robotY);
        dashed(x, robotY, robotX, robotY);
        text(robotX - 4, y + 18, GREY, "z");
        text(x - 16, robotY + 4, GREY, "x");
        robot(robotX, robotY, HEADING);
        dashed(robotX, robotY, robotX, robotY - 140);
        dashed(robotX, robotY, robotX + 140, robotY);
        arc(robotX, robotY, 112, 90, 90 - HEADING, GREY);
        text(robotX + 12, robotY - 122, GREY, "heading 35, clockwise from north");
        arc(robotX, robotY, 90, 0, 90 - HEADING, BODY);
        text(robotX + 84, robotY - 44, BODY, "ry 55, counter-clockwise");
        text(40, HEIGHT - 14, "#222", "getPose answers [x, y, z, rx, ry, rz]; heading = 90 - ry");
    }

    private void body(double x, double y) {
        title(540, "The robot, from above");
        robot(x, y, 0);
        arrow(x, y - ROBOT, x, y - 130, BODY);
        text(x + 10, y - 122, BODY, "+z forward");
        arrow(x - ROBOT, y, x - 130, y, BODY);
        text(x - 140, y - 12, BODY, "+x left");
        upwards(x, y, BODY);
        text(x - 20, y + ROBOT + 20, BODY, "+y up");
        arc(x, y, 70, 60, 120, GREY);
        text(x - 150, y - 74, GREY, "+ turns left");
        arc(x, y, 100, -40, 40, GREY);
        text(x + 60, y + 88, GREY, "LIDAR: first beam");
        text(x + 60, y + 106, GREY, "right, last left");
        text(540, HEIGHT - 14, "#222", "spin, radius, ry, gyroscope y: + is to the left");
    }

    private void title(double x, String words) {
        out.append(format("<text x=\"%.0f\" y=\"28\" font-weight=\"bold\" fill=\"#222\">%s</text>%n", x, words));
    }

    private void robot(double x, double y, double heading) {
        out.append(format("<g transform=\"translate(%.0f,%.0f) rotate(%.0f)\"><circle r=\"%.0f\" fill=\"#eee\" "
            + "stroke=\"%s\" stroke-width=\"2\"/>"
            + "<rect x=\"-38\" y=\"-9\" width=\"8\" height=\"18\" fill=\"#444\"/><rect x=\"30\" y=\"-9\" width=\"8\" "
            + "height=\"18\" fill=\"#444\"/>"
            + "<path d=\"M0,-30 L8,-14 L-8,-14 z\" fill=\"%s\"/></g>%n", x, y, heading, ROBOT, BODY, BODY));
        if (heading != 0) {
            double along = Math.toRadians(heading);
            arrow(x + ROBOT * Math.sin(along), y - ROBOT * Math.cos(along), x + 130 * Math.sin(along),
                y - 130 * Math.cos(along), BODY);
        }
    }

    private void arrow(double x1, double y1, double x2, double y2, String color) {
        out.append(format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"2\" "
            + "marker-end=\"url(#%s)\"/>%n", x1, y1, x2, y2, color, marker(color)));
    }

    private void dashed(double x1, double y1, double x2, double y2) {
        out.append(format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
            + "stroke-dasharray=\"4 4\"/>%n", x1, y1, x2, y2, GREY));
    }

    /** Draws an arc between two angles, degrees counter-clockwise from the right. */
    private void arc(double x, double y, double radius, double from, double to, String color) {
        double a = Math.toRadians(from);
        double b = Math.toRadians(to);
        out.append(format("<path d=\"M%.1f,%.1f A%.0f,%.0f 0 0 %d %.1f,%.1f\" fill=\"none\" stroke=\"%s\" "
            + "stroke-width=\"1.5\""
            + " marker-end=\"url(#%s)\"/>%n", x + radius * Math.cos(a), y - radius * Math.sin(a), radius, radius,
            to < from ? 1 : 0, x + radius * Math.cos(b), y - radius * Math.sin(b), color, marker(color)));
    }

    private void upwards(double x, double y, String color) {
        out.append(format("<circle cx=\"%.0f\" cy=\"%.0f\" r=\"7\" fill=\"#fff\" stroke=\"%s\" stroke-width=\"2\"/>"
            + "<circle cx=\"%.0f\" cy=\"%.0f\" r=\"2.5\" fill=\"%s\"/>%n", x, y, color, x, y, color));
    }

    private void text(double x, double y, String color, String words) {
        out.append(format("<text x=\"%.0f\" y=\"%.0f\" fill=\"%s\">%s</text>%n", x, y, color, words));
    }

    private static String marker(String color) {
        return "arrow" + color.substring(1);
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern.replace("%n", "\n"), values);
    }
}
