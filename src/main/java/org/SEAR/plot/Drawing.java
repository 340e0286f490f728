package org.SEAR.plot;

/** What can be drawn as a picture. One thread. */
public interface Drawing {
    /** Points. */
    int width();

    /** Points. */
    int height();

    /** Draws all of it. */
    void on(Canvas canvas);
}
