package org.SEAR.terrain.format;

/** How much of a map may be used; docs/terrain.md has the same numbers. */
public final class MapLimits {
    /** Posts of the ground that is made of maps; more than {@link #MAX_POSTS} of them are not held in memory all at once. */
    public static final int MOST_POSTS = 150_000_000;
    /** Posts that are held in memory: of one map, and of the ground that is made of maps. */
    public static final int MAX_POSTS = 16_000_000;
    /** Metres above or below 0; what is beyond counts as no data. */
    public static final double HIGHEST = 32_000;

    private MapLimits() {
    }
}
