// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

/** Limits of maps. docs/terrain.md lists the same numbers. */
public final class MapLimits {
    /**
     * Maximum number of posts of a ground built from maps. Grounds above {@link #MAX_POSTS} are not held in memory as a
     * whole.
     */
    public static final int MOST_POSTS = 150_000_000;
    /** Maximum number of posts held in memory, of one map or of a ground. */
    public static final int MAX_POSTS = 16_000_000;
    /** Greatest elevation above or below 0, metres; values beyond count as no data. */
    public static final double HIGHEST = 32_000;

    private MapLimits() {
    }
}
