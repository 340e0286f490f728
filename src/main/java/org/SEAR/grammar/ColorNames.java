// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Named colours: the 16 of HTML 4.01, section 6.5, and a selection from CSS Color Module Level 4, section 6.1.
 * Case-insensitive. Immutable, any thread.
 */
public final class ColorNames {
    private static final Pattern HEX = Pattern.compile("#[0-9a-f]{6}");
    private static final int HEXADECIMAL = 16;
    private static final int BYTE = 0xff;
    private static final Map<String, String> NAMES = new LinkedHashMap<>();

    static {
        name("black #000000, silver #c0c0c0, gray #808080, grey #808080, white #ffffff, maroon #800000, red #ff0000, "
            + "purple #800080, "
            + "fuchsia #ff00ff, green #008000, lime #00ff00, olive #808000, yellow #ffff00, navy #000080, blue "
                + "#0000ff, teal #008080, aqua #00ffff");
        name("orange #ffa500, brown #a52a2a, pink #ffc0cb, gold #ffd700, beige #f5f5dc, tan #d2b48c, violet #ee82ee, "
            + "cyan #00ffff, magenta #ff00ff, turquoise #40e0d0");
    }

    private ColorNames() {
    }

    private static void name(String list) {
        for (String entry : list.split(", ")) {
            NAMES.put(entry.split(" ")[0], entry.split(" ")[1]);
        }
    }

    /** Returns the names in the order in which messages list them. */
    public static Set<String> all() {
        return Collections.unmodifiableSet(NAMES.keySet());
    }

    /**
     * Returns a colour as hexadecimal digits.
     *
     * @param color a name or #rrggbb
     * @return #rrggbb in lower case; null if the text is neither
     */
    public static String hex(String color) {
        String small = color.toLowerCase(Locale.ROOT);
        return HEX.matcher(small).matches() ? small : NAMES.get(small);
    }

    /**
     * Returns the name of the nearest colour by Euclidean distance in RGB.
     *
     * @param rgb 0xRRGGBB
     */
    public static String near(int rgb) {
        String nearest = "";
        int least = Integer.MAX_VALUE;
        for (Map.Entry<String, String> entry : NAMES.entrySet()) {
            int other = Integer.parseInt(entry.getValue().substring(1), HEXADECIMAL);
            int off = square(rgb >> 16, other >> 16) + square(rgb >> 8, other >> 8) + square(rgb, other);
            if (off < least) {
                least = off;
                nearest = entry.getKey();
            }
        }
        return nearest;
    }

    private static int square(int shifted, int other) {
        int off = (shifted & BYTE) - (other & BYTE);
        return off * off;
    }
}
