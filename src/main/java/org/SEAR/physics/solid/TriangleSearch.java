package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.TriangleCallback;
import javax.vecmath.Vector3f;

/** Finds the triangles of a mesh near something. Simulation thread. */
public interface TriangleSearch {
    /**
     * Shows the triangles that may reach into a box.
     *
     * @param visitor takes the corners of each, only while it is called
     * @param low least x, y and z in the mesh's frame, metres, likewise high
     */
    void find(TriangleCallback visitor, Vector3f low, Vector3f high);
}
