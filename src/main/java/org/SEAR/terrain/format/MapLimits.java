package org.SEAR.terrain.format;

/** How much of a map may be used; docs/terrain.md has the same numbers. */
public final class MapLimits {
    /** Posts that are read of one map, and posts of the ground that is made of maps. */
    public static final int MAX_POSTS = 16_000_000;
    /** Metres above or below 0; what is beyond counts as no data. */
    public static final double HIGHEST = 32_000;

    private MapLimits() {
    }
}
