// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/** Appearances of the shapes of a scene. Simulation thread. */
public interface Appearances {
    /** Returns the appearance of a shape of the scene; never null. */
    Appearance of(int shape);
}
