// SPDX-License-Identifier: Apache-2.0
package org.SEAR.architecture;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Dependency graph of packages as SVG: users above the packages they use, transitive arrows left out. */
final class PackagePicture {
    private static final int WIDTH = 1100;
    private static final int ROW = 76;
    private static final int BOX = 28;
    private static final int MARGIN = 16;
    private static final double LETTER = 7.2;
    private static final int PADDING = 16;

    private final PackageGraph graph;
    private final Map<String, double[]> places = new LinkedHashMap<>();
    private final Map<String, Integer> found = new HashMap<>();
    private final int height;

    /** @param graph without a cycle */
    PackagePicture(PackageGraph graph) {
        this.graph = graph;
        Map<Integer, List<String>> rows = graph.uses().keySet().stream().collect(Collectors.groupingBy(this::row));
        height = rows.size() * ROW + MARGIN;
        for (int row = rows.size() - 1; row >= 0; row--) {
            place(new ArrayList<>(rows.get(row)), MARGIN + (rows.size() - 1 - row) * ROW);
        }
    }

    /** Places the boxes of a row side by side, ordered by the mean position of their users. */
    private void place(List<String> names, int top) {
        names.sort((a, b) -> {
            int order = Double.compare(wanted(a), wanted(b));
            return order != 0 ? order : a.compareTo(b);
        });
        double used = names.stream().mapToDouble(PackagePicture::width).sum();
        double gap = (WIDTH - used) / (names.size() + 1);
        double x = gap;
        for (String name : names) {
            places.put(name, new double[] {x, top});
            x += width(name) + gap;
        }
    }

    /** Returns the row directly below the lowest user, so that arrows are short; counted from the bottom. */
    private int row(String name) {
        Integer known = found.get(name);
        if (known == null) {
            known = users(name).mapToInt(user -> row(user) - 1).min().orElseGet(() -> graph.height(name));
            found.put(name, known);
        }
        return known;
    }

    private Stream<String> users(String name) {
        return graph.uses().keySet().stream().filter(user -> graph.uses().get(user).contains(name));
    }

    private double wanted(String name) {
        return places.keySet().stream().filter(user -> graph.direct(user).contains(name)).mapToDouble(this::middle)
            .average().orElse(WIDTH / 2.0);
    }

    private double middle(String name) {
        return places.get(name)[0] + width(name) / 2;
    }

    private static String label(String name) {
        return name.replace("org.SEAR.", "").replace("org.myrobotlab.", "mrl.");
    }

    private static double width(String name) {
        return label(name).length() * LETTER + PADDING;
    }

    String svg() {
        StringBuilder svg = new StringBuilder();
        line(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"monospace\" "
            + "font-size=\"12\">", WIDTH, height);
        line(svg, "<title>The packages of SEAR's plug-in, read from its classes</title>");
        line(svg, "<defs><marker id=\"a\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"7\" "
            + "markerHeight=\"7\" orient=\"auto\"><path d=\"M0 0L8 4L0 8z\" fill=\"#456\"/></marker></defs>");
        line(svg, "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>", WIDTH, height);
        places.keySet().forEach(user -> graph.direct(user).forEach(used -> arrow(svg, user, used)));
        places.forEach((name, place) -> box(svg, name, place));
        return svg.append("</svg>\n").toString();
    }

    private void arrow(StringBuilder svg, String user, String used) {
        double x1 = middle(user);
        double y1 = places.get(user)[1] + BOX;
        double x2 = middle(used);
        double y2 = places.get(used)[1];
        line(svg, "<path d=\"M%.1f %.1fC%.1f %.1f %.1f %.1f %.1f %.1f\" fill=\"none\" stroke=\"#456\" "
            + "marker-end=\"url(#a)\"/>", x1, y1, x1, y1 + ROW / 2.0, x2, y2 - ROW / 2.0, x2, y2);
    }

    private void box(StringBuilder svg, String name, double[] place) {
        String fill = name.startsWith("org.SEAR.") ? "#e6f0fa" : "#fbeedd";
        line(svg, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%d\" rx=\"5\" fill=\"%s\" stroke=\"#456\"/>",
            place[0], place[1], width(name), BOX, fill);
        line(svg, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%s</text>", middle(name), place[1] + 18,
            label(name));
    }

    private static void line(StringBuilder svg, String format, Object... values) {
        svg.append(String.format(Locale.ROOT, format, values)).append('\n');
    }
}
