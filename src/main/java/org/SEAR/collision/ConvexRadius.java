package org.SEAR.collision;

/** How much of a shape is skin around its core, see {@link ConvexShape#coreSupport}. */
final class ConvexRadius {
    /** Metres. */
    private static final double MOST = 1e-3;
    /** Share of the least half size. */
    private static final double SHARE = 0.1;

    private ConvexRadius() {
    }

    /** @param least half of the shape's least size, metres */
    static double of(double least) {
        return Math.min(MOST, SHARE * least);
    }
}
