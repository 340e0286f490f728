// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Map;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.TextRule;

/**
 * A model from a file below assets: OGRE mesh.xml, .j3o, .obj, .gltf, .glb or .blend. It is an obstacle, a part of a
 * robot, or the terrain, whose centre is then the world's origin. It may be invisible to beams.
 */
@Described("a model from a file: an obstacle, a part of a robot, or the terrain")
public class Model extends Shape {
    @Param(doc = "model file below assets: .mesh.xml, .j3o, .obj, .gltf, .glb or .blend", text = TextRule.ASSET,
        required = true)
    private String path;
    @Param(doc = "whether it is the terrain: fixed, its centre is the world's origin")
    private boolean terrain;

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
    public Model(String name, String path, double mass, String image, double x, double y, double z, double rx, double ry, double rz) {
        super(name, mass);
        this.path = path;
        wrap(image);
        pose(x, y, z, rx, ry, rz);
        created(Model.class);
    }

    @Override
    String whyNoComponent() {
        return terrain ? " is the terrain, which can't be a component" : super.whyNoComponent();
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (terrain && getMass() != 0) {
            faults.add("mass", getMass(), "0 kg for a terrain");
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
     * @throws IllegalArgumentException if it has a mass
     */
    public void setTerrain(boolean on) {
        if (on && getMass() != 0) {
            throw new IllegalArgumentException(label() + ": mass is " + Parameter.format(getMass()) + ", legal: 0 kg for a terrain");
        }
        terrain = checked("terrain", on);
        changed();
    }

    @Override
    protected String defaultColor() {
        return "#6b8e23";
    }
}
