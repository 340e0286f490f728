// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;
import org.SEAR.grammar.TextRule;

/**
 * The {@code .yaml} file of a ROS map, by the page of ROS's map_server: {@code image}, {@code resolution},
 * {@code origin}, {@code occupied_thresh}, {@code negate}, {@code mode}. One key per line; a list in brackets or one
 * item per line. Immutable.
 */
final class RosMap {
    private static final int LONGEST = 1 << 16;
    private static final double FAR = 100_000;
    private static final int WHITE = 255;
    private static final int FULL = 100;

    /** Path of the picture below assets. */
    final String image;
    /** Side of a pixel, metres. */
    final double resolution;
    /** Lower left corner of the picture, metres east and north. */
    final double originX;
    final double originY;
    /** Rotation of the picture about this corner, radians, counter-clockwise from above. */
    final double yaw;
    private final double occupied;
    private final boolean negate;
    private final boolean raw;
    private final String file;
    private final Map<String, String> values;

    private RosMap(String file, Map<String, String> values) throws IOException {
        this.file = file;
        this.values = values;
        image = beside(text("image"));
        resolution = number("resolution", text("resolution"), 0.0001, 1000);
        String[] origin = text("origin").replaceAll("^\\[|\\]$", "").split(",", -1);
        if (origin.length != 3) {
            throw FileLimits.wrong(file, "origin", text("origin"), "[x, y, yaw]");
        }
        originX = number("origin's x", origin[0], -FAR, FAR);
        originY = number("origin's y", origin[1], -FAR, FAR);
        yaw = number("origin's yaw", origin[2], -2 * Math.PI, 2 * Math.PI);
        occupied = number("occupied_thresh", values.getOrDefault("occupied_thresh", "0.65"), 0, 1);
        String inverted = values.getOrDefault("negate", "0");
        if (!inverted.matches("0|1|true|false")) {
            throw FileLimits.wrong(file, "negate", inverted, "0 or 1");
        }
        negate = inverted.equals("1") || inverted.equals("true");
        String mode = values.getOrDefault("mode", "trinary");
        if (!mode.matches("trinary|scale|raw")) {
            throw FileLimits.wrong(file, "mode", mode, "trinary, scale or raw");
        }
        raw = mode.equals("raw");
    }

    /** @throws IOException with the file, the problem and legal values */
    static RosMap read(String path, Assets assets) throws IOException {
        byte[] bytes;
        try (InputStream in = assets.open(path)) {
            bytes = in.readNBytes(LONGEST + 1);
        }
        FileLimits.range(path, "the file's size", bytes.length, 1, LONGEST);
        Map<String, String> values = new HashMap<>();
        String last = null;
        for (String line : new String(bytes, StandardCharsets.UTF_8).split("\r?\n|\r")) {
            String plain = line.replaceAll("(^|\\s)#.*$", "").trim();
            int colon = plain.indexOf(':');
            if (plain.startsWith("- ") && last != null) {
                values.merge(last, plain.substring(2).trim(), (a, b) -> a.isEmpty() ? b : a + "," + b);
            } else if (colon > 0) {
                last = plain.substring(0, colon).trim();
                values.put(last, unquoted(plain.substring(colon + 1).trim()));
            } else if (!plain.isEmpty() && !plain.startsWith("---") && !plain.startsWith("%")) {
                throw FileLimits.wrong(path, "a line", plain, "key: value");
            }
        }
        return new RosMap(path, values);
    }

    private static String unquoted(String text) {
        return text.matches("\".*\"|'.*'") && text.length() > 1 ? text.substring(1, text.length() - 1) : text;
    }

    private String text(String key) throws IOException {
        String value = values.get(key);
        if (value == null || value.isEmpty()) {
            throw FileLimits.wrong(file, key, "missing", key + ": a value, as map_server writes it");
        }
        return value;
    }

    /** Returns the path below assets of a picture beside the file. */
    private String beside(String name) throws IOException {
        String plain = name.startsWith("./") ? name.substring(2) : name;
        String lower = plain.toLowerCase(Locale.ROOT);
        if (!TextRule.ASSET.isLegal(plain) || lower.endsWith(".yaml") || lower.endsWith(".yml")) {
            throw FileLimits.wrong(file, "image", name, "a picture beside the file, or in a folder beside it");
        }
        return file.substring(0, file.lastIndexOf('/') + 1) + plain;
    }

    private double number(String key, String text, double low, double high) throws IOException {
        double value = Double.NaN;
        try {
            value = Double.parseDouble(text.trim());
        } catch (NumberFormatException e) {
            throw FileLimits.wrong(file, key, text, "a number from " + low + " to " + high, e);
        }
        if (!(value >= low && value <= high)) {
            throw FileLimits.wrong(file, key, text, "a number from " + low + " to " + high);
        }
        return value;
    }

    /**
     * Returns whether a pixel is occupied.
     *
     * @param grey 0 to 255; -1 for a transparent pixel
     */
    boolean isWall(int grey) {
        if (grey < 0) {
            return false;
        }
        if (raw) {
            return grey <= FULL && grey > occupied * FULL;
        }
        return (negate ? grey : WHITE - grey) > occupied * WHITE;
    }
}
