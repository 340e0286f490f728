package org.SEAR.view;

/** Notices a machine that draws so slowly that shadows should take less time. Window thread only. */
final class FrameRateMonitor {
    /** Real seconds in which shaders are compiled and textures loaded: they don't count. */
    private static final float WARM_UP = 2;
    /** Real seconds over which pictures are counted. */
    private static final float TRIAL = 2;
    /** Pictures a second that a window should show. */
    private static final float ENOUGH = 30;

    private float time = -WARM_UP;
    private int frames;
    private float rate = Float.NaN;

    /**
     * Counts a picture.
     *
     * @return whether the last trial showed too few
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
