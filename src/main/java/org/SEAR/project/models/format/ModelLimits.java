// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

/**
 * Limits of models, also listed in docs/projects.md: above realistic models, and far below the size that stops a
 * program.
 */
public final class ModelLimits {
    /** Bytes of a model's file. */
    public static final long MAX_FILE = 256L << 20;
    /** Unpacked bytes of a .blend packed with gzip. */
    public static final int MAX_BLEND = 64 << 20;
    /** Nodes of a model's scene. */
    public static final int MAX_NODES = 10_000;
    /** Depth of nested nodes. */
    public static final int MAX_DEPTH = 100;
    /** Triangles and vertices of a model, each; a mesh counts once per node that shows it. */
    public static final int MAX_TRIANGLES = 4_000_000;
    /** Distance from the model's origin along each axis before scaling, metres. */
    public static final float MAX_COORDINATE = 1e6f;

    /** Characters of a line of an .obj with its continuations. */
    static final int MAX_LINE = 4 << 20;
    /** Corners of a face that is not convex. */
    static final int MAX_CORNERS = 1000;

    private ModelLimits() {
    }
}
