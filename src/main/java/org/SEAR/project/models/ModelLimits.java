package org.SEAR.project.models;

/**
 * Limits of models, also listed in docs/projects.md: above realistic models, and far below the size that stops a
 * program.
 */
final class ModelLimits {
    /** Bytes of a model's file. */
    static final long MAX_FILE = 256L << 20;
    /** Unpacked bytes of a .blend packed with gzip. */
    static final int MAX_BLEND = 64 << 20;
    /** Nodes of a model's scene. */
    static final int MAX_NODES = 10_000;
    /** Depth of nested nodes. */
    static final int MAX_DEPTH = 100;
    /** Triangles and vertices of a model, each; a mesh counts once per node that shows it. */
    static final int MAX_TRIANGLES = 4_000_000;
    /** Distance from the model's origin along each axis before scaling, metres. */
    static final float MAX_COORDINATE = 1e6f;

    private ModelLimits() {
    }
}
