// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.TriangleCallback;
import javax.vecmath.Vector3f;

/** Finds the triangles of a mesh in a box. Simulation thread. */
public interface TriangleSearch {
    /**
     * Visits the triangles that may reach into a box.
     * @param visitor takes the corners of each; they are valid only during the call
     * @param low smallest x, y and z in the mesh's frame, metres, likewise the greatest in high
     */
    void find(TriangleCallback visitor, Vector3f low, Vector3f high);
}
