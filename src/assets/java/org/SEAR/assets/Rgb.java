// SPDX-License-Identifier: Apache-2.0
package org.SEAR.assets;

/** Colour, components from 0 to 1. Immutable. */
final class Rgb {
    static final Rgb BLACK = new Rgb(0, 0, 0);
    static final Rgb WHITE = new Rgb(1, 1, 1);

    final double r;
    final double g;
    final double b;

    Rgb(double r, double g, double b) {
        this.r = r;
        this.g = g;
        this.b = b;
    }

    /** Creates a colour from 0xrrggbb. */
    static Rgb of(int rgb) {
        return new Rgb((rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
    }

    Rgb plus(Rgb o) {
        return new Rgb(r + o.r, g + o.g, b + o.b);
    }

    Rgb times(double f) {
        return new Rgb(r * f, g * f, b * f);
    }

    /** Mixes two colours: this one at share 0, the other at share 1. */
    Rgb mix(Rgb o, double share) {
        double s = Math.max(0, Math.min(1, share));
        return times(1 - s).plus(o.times(s));
    }

    int toInt() {
        return part(r) << 16 | part(g) << 8 | part(b);
    }

    private static int part(double value) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
    }
}
