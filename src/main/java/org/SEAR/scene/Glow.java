// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

/** Displayed colour of a light. A light that is off still shows some of its colour. Any thread. */
public final class Glow {
    /** Share of its colour that a light shows when off. */
    private static final double DARK = 0.2;
    private static final int BYTE = 0xff;

    private Glow() {
    }

    /**
     * Returns the displayed colour.
     * @param color of the light, {@code #rrggbb}
     * @param brightness 0 to 1
     * @return {@code #rrggbb}
     */
    public static String of(String color, double brightness) {
        double share = DARK + (1 - DARK) * brightness;
        int full = Integer.parseInt(color.substring(1), 16);
        return String.format("#%02x%02x%02x", channel(full >> 16, share), channel(full >> 8, share),
            channel(full, share));
    }

    private static int channel(int color, double share) {
        return (int) Math.round((color & BYTE) * share);
    }
}
