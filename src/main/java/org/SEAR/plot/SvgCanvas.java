// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

import java.util.Locale;

/** Canvas for an SVG file, with the same bytes on every computer. One thread. */
final class SvgCanvas implements Canvas {
    private static final String FONT = "DejaVu Sans, Verdana, Arial, sans-serif";
    private final StringBuilder out = new StringBuilder();

    SvgCanvas(int width, int height) {
        add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
            + "font-family=\"%s\">\n", width, height, width, height, FONT);
        add("<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n", width, height);
    }

    private void add(String format, Object... values) {
        out.append(String.format(Locale.ROOT, format, values));
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, String color, double width) {
        add("<line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\" stroke=\"%s\" stroke-width=\"%.1f\"/>\n", x1, y1, x2,
            y2, color, width);
    }

    @Override
    public void polyline(double[] x, double[] y, int count, String color, double width) {
        add("<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\" stroke-linejoin=\"round\" points=\"",
            color, width);
        for (int i = 0; i < count; i++) {
            add("%s%.2f,%.2f", i == 0 ? "" : " ", x[i], y[i]);
        }
        add("\"/>\n");
    }

    @Override
    public void area(double[] x, double[] y, String color, double opacity, String edge) {
        add("<polygon fill=\"%s\" fill-opacity=\"%.2f\" stroke=\"%s\" points=\"", color, opacity, edge);
        for (int i = 0; i < x.length; i++) {
            add("%s%.2f,%.2f", i == 0 ? "" : " ", x[i], y[i]);
        }
        add("\"/>\n");
    }

    @Override
    public void text(String text, double x, double y, Anchor anchor, int size) {
        write(text, x, y, anchor, size, "");
    }

    private void write(String text, double x, double y, Anchor anchor, int size, String more) {
        String at = anchor == Anchor.LEFT ? "start" : anchor == Anchor.RIGHT ? "end" : "middle";
        add("<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\" font-size=\"%d\"%s>%s</text>\n", x, y, at, size, more,
            escaped(text));
    }

    @Override
    public void label(String text, double x, double y, Anchor anchor, int size) {
        write(text, x, y, anchor, size, " paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\" "
            + "stroke-linejoin=\"round\"");
    }

    @Override
    public void upwards(String text, double x, double y, int size) {
        add("<text transform=\"translate(%.2f %.2f) rotate(-90)\" text-anchor=\"middle\" font-size=\"%d\">%s</text>\n",
            x, y, size, escaped(text));
    }

    private static String escaped(String text) {
        return text.replaceAll("\\p{Cntrl}", " ").replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    /** Returns the complete file. */
    String file() {
        return out + "</svg>\n";
    }
}
