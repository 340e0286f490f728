// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.asset.AssetManager;
import com.jme3.light.AmbientLight;
import com.jme3.light.DirectionalLight;
import com.jme3.material.MatParamOverride;
import com.jme3.math.ColorRGBA;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.renderer.ViewPort;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.shader.VarType;
import org.SEAR.camera.Daylight;

/** Sun, sky, and the sun's shadows. Window thread only. */
public final class Lighting {
    private final Geometry sky;
    private final ViewPort view;
    private final SunShadow shadows;
    private boolean shadowsOn;

    public Lighting(AssetManager assets, Node root, ViewPort view) {
        this.view = view;
        sky = Sky.make(assets);
        root.attachChild(sky);
        double[] toSun = Daylight.toSun();
        Vector3f sunlight = new Vector3f((float) -toSun[0], (float) -toSun[1], (float) -toSun[2]);
        root.addMatParamOverride(new MatParamOverride(VarType.Vector3, "ToSun", sunlight.negate()));
        root.addMatParamOverride(new MatParamOverride(VarType.Vector3, "SunLight", vector(Daylight.sun())));
        root.addMatParamOverride(new MatParamOverride(VarType.Vector3, "SkyLight", vector(Daylight.sky())));
        // for materials that belong to models
        root.addLight(new DirectionalLight(sunlight, color(Daylight.sun())));
        root.addLight(new AmbientLight(color(Daylight.sky())));
        shadows = new SunShadow(assets, root, sunlight);
        setShadows(true);
    }

    private static ColorRGBA color(float[] light) {
        return new ColorRGBA(light[0], light[1], light[2], 1);
    }

    private static Vector3f vector(float[] light) {
        return new Vector3f(light[0], light[1], light[2]);
    }

    public boolean hasShadows() {
        return shadowsOn;
    }

    public void setShadows(boolean on) {
        if (on != shadowsOn) {
            shadowsOn = on;
            if (on) {
                shadows.showIn(view);
            } else {
                shadows.hideIn(view);
            }
        }
    }

    /** Reduces shadow updates of moving objects to every third frame. */
    public void hurryShadows() {
        shadows.hurry();
    }

    public boolean areShadowsHurried() {
        return shadows.isHurried();
    }

    /** Returns the number of objects drawn for shadows so far. Shadows are redrawn only where an object has moved. */
    public int shadowDraws() {
        return shadows.drawn();
    }

    /** Returns the background. */
    public Spatial sky() {
        return sky;
    }

    /** Centres the sky on the camera. */
    public void follow(Camera camera) {
        sky.setLocalTranslation(camera.getLocation());
    }
}
