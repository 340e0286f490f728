// SPDX-License-Identifier: Apache-2.0
package org.SEAR.assets;

/** SEAR's bundled textures as functions of position. All are tileable except the Roomba's top and the track. */
final class Textures {
    private static final Rgb CARDBOARD = Rgb.of(0xb98a55);
    private static final Rgb TAPE = Rgb.of(0xd8bf8a);
    private static final Rgb INK = Rgb.of(0x4a3420);
    private static final Rgb ORANGE = Rgb.of(0xf2590c);
    private static final Rgb BIN_BLUE = Rgb.of(0x1f5fa8);
    private static final Rgb MORTAR = Rgb.of(0xb9b2a6);
    private static final Rgb BRICK = Rgb.of(0x9a4630);
    private static final Rgb STEEL_RED = Rgb.of(0xa8382c);
    private static final Rgb TILE = Rgb.of(0xd9d6cf);
    private static final Rgb JOINT = Rgb.of(0x8d8a84);

    private Textures() {
    }

    /** Returns 1 inside a band around zero, with a soft edge. */
    private static double line(double distance, double halfWidth) {
        return Math.max(0, Math.min(1, 1.5 - Math.abs(distance) / halfWidth));
    }

    /** One side of a cardboard box: flutes, tape across the middle, arrows for the upper side. */
    static Rgb cardboard(double u, double v) {
        double flutes = 0.03 * Math.sin(v * 2 * Math.PI * 90) + 0.12 * (Noise.cloud(u, v, 4, 1) - 0.5);
        Rgb color = CARDBOARD.times(1 + flutes);
        double edge = Math.min(Math.min(u, 1 - u), Math.min(v, 1 - v));
        color = color.mix(INK, 0.45 * line(edge, 0.012));
        if (Math.abs(v - 0.5) < 0.06) {
            color = color.mix(TAPE, 0.75 + 0.15 * Noise.smooth(u, v, 64, 8, 2));
        }
        return color.mix(INK, 0.8 * Math.max(arrow(u - 0.14, v - 0.16), arrow(u - 0.26, v - 0.16)));
    }

    private static double arrow(double x, double y) {
        boolean shaft = Math.abs(x) < 0.014 && y > -0.08 && y < 0.05;
        boolean head = y >= 0.03 && y < 0.1 && Math.abs(x) < (0.1 - y) * 0.65;
        boolean bar = Math.abs(x) < 0.055 && y < -0.09 && y > -0.105;
        return shaft || head || bar ? 1 : 0;
    }

    /** Side of a traffic cone: orange with two white bands, dirt towards the bottom. */
    static Rgb cone(double u, double v) {
        boolean band = v > 0.32 && v < 0.47 || v > 0.6 && v < 0.72;
        Rgb color = band ? Rgb.WHITE.times(0.95) : ORANGE;
        double dirt = (0.35 - v) * 0.8 * Noise.cloud(u, v, 8, 3);
        return color.times(0.94 + 0.1 * Noise.cloud(u, v, 16, 4)).mix(Rgb.of(0x3a2f28), dirt);
    }

    /** Side of a recycling bin: blue plastic with ribs, a rim, and two signs of three arrows. */
    static Rgb recycling(double u, double v) {
        double rib = 0.07 * Math.cos(u * 2 * Math.PI * 24);
        Rgb color = BIN_BLUE.times(1 + rib + 0.08 * (Noise.cloud(u, v, 16, 5) - 0.5));
        if (v > 0.9) {
            color = BIN_BLUE.times(v > 0.92 ? 1.35 : 0.55);
        }
        double x = (u * 2 % 1 - 0.5) * 1.6;
        return color.mix(Rgb.WHITE, 0.92 * threeArrows(x, v - 0.48));
    }

    /** Three bent arrows that follow each other around a triangle. */
    private static double threeArrows(double x, double y) {
        double best = 0;
        for (int i = 0; i < 3; i++) {
            double turn = i * 2 * Math.PI / 3;
            double along = x * Math.cos(turn) + y * Math.sin(turn);
            double out = -x * Math.sin(turn) + y * Math.cos(turn) + 0.15;
            boolean shaft = Math.abs(out) < 0.038 && along > -0.2 && along < 0.07;
            boolean head = along >= 0.06 && along < 0.17 && Math.abs(out) < (0.17 - along) * 0.75;
            best = shaft || head ? 1 : best;
        }
        return best;
    }

    /** Four floor tiles. */
    static Rgb tiles(double u, double v) {
        double x = u * 2 % 1;
        double y = v * 2 % 1;
        int tile = (int) (u * 2) + 2 * (int) (v * 2);
        Rgb color = TILE.times(0.93 + 0.05 * Noise.at(tile, 1, 6) + 0.08 * (Noise.cloud(u, v, 6, 7 + tile) - 0.5));
        double joint = Math.min(Math.min(x, 1 - x), Math.min(y, 1 - y));
        return color.mix(Rgb.WHITE, 0.3 * line(joint - 0.022, 0.006)).mix(JOINT, line(joint, 0.012));
    }

    /** Brick wall of eight courses. */
    static Rgb brick(double u, double v) {
        double course = v * 8;
        int row = (int) course;
        double along = u * 4 + (row % 2 == 0 ? 0 : 0.5);
        int brick = Math.floorMod((int) Math.floor(along), 4);
        double x = along - Math.floor(along);
        double y = course - row;
        double joint = Math.min(Math.min(x, 1 - x) * 2, Math.min(y, 1 - y));
        double grain = 0.75 + 0.25 * Noise.at(brick, row, 8) + 0.3 * (Noise.cloud(u, v, 16, 9) - 0.5);
        Rgb stone = BRICK.times(grain);
        return stone.mix(MORTAR.times(0.85 + 0.2 * Noise.cloud(u, v, 32, 10)), line(joint, 0.055));
    }

    /** One side of a shipping container: corrugated steel, a frame, some rust. */
    static Rgb container(double u, double v) {
        double wave = Math.sin(u * 2 * Math.PI * 16);
        Rgb color = STEEL_RED.times(0.85 + 0.2 * Math.tanh(3 * wave));
        double rust = Noise.cloud(u, v, 6, 11) * 1.5 - 0.85 + 0.25 * (1 - v);
        color = color.mix(Rgb.of(0x5c2f1a), rust * 1.5);
        boolean frame = v < 0.05 || v > 0.95 || u < 0.015 || u > 0.985;
        return frame ? STEEL_RED.times(0.62 + 0.1 * Noise.cloud(u, v, 16, 12)) : color;
    }

    /** A small cleaning robot from above, front upwards: bumper, button, vents. */
    static Rgb roomba(double u, double v) {
        double x = u * 2 - 1;
        double y = v * 2 - 1;
        double radius = Math.hypot(x, y);
        Rgb shell = Rgb.of(0xd9dadb).times(0.96 + 0.05 * y + 0.03 * Noise.cloud(u, v, 32, 13));
        Rgb color = radius > 1 ? Rgb.of(0x2c2d30) : shell;
        boolean bumper = radius > 0.84 && radius <= 1 && y > -0.05;
        color = bumper ? Rgb.of(0x3a3c40).times(0.9 + 0.3 * (1 - Math.abs(radius - 0.92) / 0.08)) : color;
        color = color.mix(Rgb.of(0x55585c), line(radius - 0.7, 0.012) + line(radius - 0.84, 0.008));
        if (Math.hypot(x, y + 0.12) < 0.17) {
            color = Rgb.of(0x2fa84f).mix(Rgb.WHITE, 0.55 * line(Math.hypot(x, y + 0.12) - 0.11, 0.015));
        }
        for (int i = -3; i <= 3; i++) {
            boolean vent = Math.abs(x - i * 0.07) < 0.014 && y < -0.42 && y > -0.6;
            color = vent ? Rgb.of(0x303236) : color;
        }
        boolean eye = Math.hypot(x, y - 0.76) < 0.06;
        return eye ? Rgb.of(0x101418).mix(Rgb.WHITE, line(Math.hypot(x - 0.015, y - 0.775), 0.018)) : color;
    }

    /** Tread of a wheel. */
    static Rgb tyre(double u, double v) {
        double block = Math.sin(u * 2 * Math.PI * 20 + (v < 0.5 ? 0 : Math.PI));
        boolean groove = Math.abs(v - 0.5) < 0.04 || block > 0.75;
        return Rgb.of(groove ? 0x141414 : 0x2b2b2c).times(0.9 + 0.25 * Noise.cloud(u, v, 16, 14));
    }

    /** Lawn. */
    static Rgb grass(double u, double v) {
        double blades = Noise.smooth(u, v, 128, 32, 15) * 0.5 + Noise.cloud(u, v, 8, 16) * 0.5;
        return Rgb.of(0x2f5a20).mix(Rgb.of(0x7fa94a), blades);
    }

    /**
     * Floor of 2 m x 2 m with a 20 mm wide track of black tape: 0.7 + 0.15 cos 3a metres from the centre in direction
     * a.
     */
    static Rgb lineTrack(double u, double v) {
        double x = 1 - 2 * v;
        double z = 1 - 2 * u;
        double angle = Math.atan2(z, x);
        double radius = 0.7 + 0.15 * Math.cos(3 * angle);
        double slope = 0.45 * Math.sin(3 * angle) / radius;
        double off = (Math.hypot(x, z) - radius) / Math.hypot(1, slope);
        return Rgb.of(Math.abs(off) < 0.01 ? 0x141414 : 0xf2f0ea);
    }

    /** Bark of a tree. */
    static Rgb bark(double u, double v) {
        double bent = u + 0.03 * Noise.smooth(u, v, 4, 4, 17);
        double ridges = Noise.smooth(bent, v, 24, 5, 18) * 0.7 + Noise.cloud(u, v, 16, 19) * 0.3;
        return Rgb.of(0x2e2117).mix(Rgb.of(0x8a6a4b), ridges);
    }

    /** Many small leaves. */
    static Rgb leaves(double u, double v) {
        double leaf = 0;
        double shade = 0;
        int cells = 24;
        int cx = (int) (u * cells);
        int cy = (int) (v * cells);
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                int gx = Math.floorMod(cx + dx, cells);
                int gy = Math.floorMod(cy + dy, cells);
                double x = u * cells - (cx + dx + Noise.at(gx, gy, 20));
                double y = v * cells - (cy + dy + Noise.at(gx, gy, 21));
                double turn = 6.28 * Noise.at(gx, gy, 22);
                double along = (x * Math.cos(turn) + y * Math.sin(turn)) / 0.75;
                double across = (y * Math.cos(turn) - x * Math.sin(turn)) / 0.38;
                double depth = 1 - along * along - across * across;
                double height = Noise.at(gx, gy, 23) + 0.01;
                if (depth > 0 && height > leaf) {
                    leaf = height;
                    shade = 0.35 + 0.5 * height + 0.15 * depth - 0.25 * line(across, 0.12);
                }
            }
        }
        return Rgb.of(0x14290f).mix(Rgb.of(0x7cb342), shade);
    }
}
