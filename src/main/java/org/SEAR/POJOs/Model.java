// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Map;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.TextRule;

/**
 * A model from a file below assets: OGRE mesh.xml, .j3o, .obj, .gltf, .glb, .stl, .ply, .dae or .blend. It is an
 * obstacle, a part of a robot, or the terrain, whose centre is then the world's origin. It may be invisible to beams.
 */
@Described("a model from a file: an obstacle, a part of a robot, or the terrain")
public class Model extends Shape {
    /** Collision shape: the convex hull. */
    public static final String HULL = "hull";
    /** Collision shape: convex parts. */
    public static final String PARTS = "parts";
    /** Collision shape of fixed models: the triangles. */
    public static final String EXACT = "exact";

    /** Legal collision shapes of a model that moves. */
    public static final String MOVABLE = "parts or hull for a model that moves: only fixed models (mass 0, on no robot)"
        + " collide by their exact triangles";

    @Param(doc = "model file below assets: .mesh.xml, .j3o, .obj, .gltf, .glb, .stl, .ply, .dae or .blend",
        text = TextRule.ASSET, required = true)
    private String path;
    @Param(doc = "whether it is the terrain: fixed, its centre is the world's origin")
    private boolean terrain;
    @Param(doc = "shape in collisions: its convex hull, convex parts, or its exact triangles (fixed models only); "
        + "default hull if it has a mass or belongs to a robot, else exact", values = {HULL, PARTS, EXACT})
    private String collision;

    /** For reading from a file. */
    protected Model() {
    }

    /**
     * Fixed in place, mass 0.
     *
     * @param path below assets
     */
    public Model(String name, String path) {
        this(name, path, 0);
    }

    /** @param mass kg, 0 fixes it in place */
    public Model(String name, String path, double mass) {
        this(name, path, mass, 0, 0, 0, 0, 0, 0);
    }

    /**
     * With a picture that replaces the model's textures.
     *
     * @param image path below assets
     */
    public Model(String name, String path, double mass, String image) {
        this(name, path, mass, image, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z), metres. */
    public Model(String name, String path, double mass, double x, double y, double z) {
        this(name, path, mass, x, y, z, 0, 0, 0);
    }

    /** At (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Model(String name, String path, double mass, double x, double y, double z, double rx, double ry, double rz) {
        this(name, path, mass, null, x, y, z, rx, ry, rz);
    }

    /** With all parameters. */
    public Model(String name, String path, double mass, String image, double x, double y, double z, double rx,
        double ry, double rz) {
        super(name, mass);
        this.path = path;
        wrap(image);
        pose(x, y, z, rx, ry, rz);
        created(Model.class);
    }

    @Override
    String whyNoComponent() {
        if (EXACT.equals(collision)) {
            return " collides by its exact triangles, which is only legal for fixed models; legal: "
                + "setCollision(\"parts\") before";
        }
        return terrain ? " is the terrain, which can't be a component" : super.whyNoComponent();
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (terrain && getMass() != 0) {
            faults.add("mass", getMass(), "0 kg for a terrain");
        }
        if (EXACT.equals(collision) && getMass() != 0) {
            faults.add("collision", collision, MOVABLE);
        }
        if (terrain && collision != null && !EXACT.equals(collision)) {
            faults.add("collision", collision, "exact for a terrain");
        }
    }

    public String getPath() {
        return path;
    }

    public boolean isTerrain() {
        return terrain;
    }

    /** Adds {@code terrain}: whether it is ground. */
    @Override
    protected void addDrawingProperties(Map<String, Object> properties) {
        super.addDrawingProperties(properties);
        properties.put("terrain", terrain);
    }

    @Override
    public boolean isGround() {
        return terrain;
    }

    /**
     * Makes the model the terrain: fixed, its centre is the world's origin.
     *
     * @throws IllegalArgumentException if it has a mass or collides by its hull or by parts
     */
    public void setTerrain(boolean on) {
        if (on && getMass() != 0) {
            throw new IllegalArgumentException(label() + ": mass is " + Parameter.format(getMass())
                + ", legal: 0 kg for a terrain");
        }
        if (on && collision != null && !EXACT.equals(collision)) {
            throw new IllegalArgumentException(label() + ": collision is \"" + collision
                + "\", legal: exact for a terrain");
        }
        terrain = checked("terrain", on);
        changed();
    }

    /**
     * Returns the shape in collisions: {@code hull}, {@code parts} or {@code exact}. The default is {@code hull} with a
     * mass or on a robot, else {@code exact}.
     */
    public String getCollision() {
        return collision != null ? collision : getMass() != 0 || robot() != null ? HULL : EXACT;
    }

    /** Returns whether the shape in collisions is set, and not the default. */
    public boolean hasCollision() {
        return collision != null;
    }

    /** @throws IllegalArgumentException also if the model collides by its exact triangles and the mass isn't 0 */
    @Override
    public void setMass(double kg) {
        if (EXACT.equals(collision) && kg != 0) {
            throw new IllegalArgumentException(label() + ": collision is \"exact\", legal: " + MOVABLE);
        }
        super.setMass(kg);
    }

    /**
     * Sets the shape in collisions. Beams and cameras always use the triangles.
     *
     * @param shape {@code hull}: the convex hull, which fills hollows; {@code parts}: at most 32 convex parts, made at
     *     the start, from at most 250,000 triangles; {@code exact}: the triangles, for a fixed model only; null for
     *     the default
     * @throws IllegalArgumentException if the shape is none of these, or doesn't suit a model that moves or the terrain
     */
    public void setCollision(String shape) {
        String checked = checked("collision", shape);
        String legal = !EXACT.equals(checked) ? checked != null && terrain ? "exact for a terrain" : null
            : getMass() != 0 || robot() != null ? MOVABLE : null;
        if (legal != null) {
            throw new IllegalArgumentException(label() + ": collision is \"" + checked + "\", legal: " + legal);
        }
        collision = checked;
        changed();
    }

    @Override
    protected String defaultColor() {
        return "#6b8e23";
    }
}
