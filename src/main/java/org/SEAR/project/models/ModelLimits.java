package org.SEAR.project.models;

/** How large models may be; docs/projects.md has the same numbers. Generous for what people draw, and far below what stops a program. */
final class ModelLimits {
    /** Bytes of a model's file. */
    static final long MAX_FILE = 256L << 20;
    /** Bytes of a .blend that is packed with gzip, when unpacked. */
    static final int MAX_BLEND = 64 << 20;
    /** Nodes of a model's scene. */
    static final int MAX_NODES = 10_000;
    /** How deep nodes may be nested. */
    static final int MAX_DEPTH = 100;
    /** Triangles and vertices of a model, each; a mesh that several nodes show counts each time. */
    static final int MAX_TRIANGLES = 4_000_000;
    /** Metres from the model's origin in each direction, before the object's scale. */
    static final float MAX_COORDINATE = 1e6f;

    private ModelLimits() {
    }
}
