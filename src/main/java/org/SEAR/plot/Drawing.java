// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

/** Something that can be drawn as a picture. One thread. */
public interface Drawing {
    /** Returns the width, points. */
    int width();

    /** Returns the height, points. */
    int height();

    /** Draws everything on the canvas. */
    void on(Canvas canvas);
}
