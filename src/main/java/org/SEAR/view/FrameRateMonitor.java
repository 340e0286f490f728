// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

/** Detects a machine that draws too slowly for full shadow updates. Window thread only. */
final class FrameRateMonitor {
    /** Initial time, real seconds, excluded because shaders compile and textures load. */
    private static final float WARM_UP = 2;
    /** Period over which frames are counted, real seconds. */
    private static final float TRIAL = 2;
    /** Minimum frame rate, frames per second. */
    private static final float ENOUGH = 30;

    private float time = -WARM_UP;
    private int frames;
    private float rate = Float.NaN;

    /**
     * Counts a frame.
     * @return whether a period has ended below the minimum frame rate
     */
    boolean count(float frameTime) {
        time += frameTime;
        if (time < 0) {
            return false;
        }
        frames++;
        if (time < TRIAL) {
            return false;
        }
        rate = frames / time;
        time = 0;
        frames = 0;
        return rate < ENOUGH;
    }
}
