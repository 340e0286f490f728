package org.SEAR.view.scene;

import com.jme3.asset.AssetManager;
import com.jme3.light.AmbientLight;
import com.jme3.light.DirectionalLight;
import com.jme3.math.ColorRGBA;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.renderer.ViewPort;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.shadow.DirectionalLightShadowRenderer;
import com.jme3.shadow.EdgeFilteringMode;
import org.SEAR.camera.Daylight;

/** Sun, sky, and the sun's shadows. Window thread only. */
public final class Lighting {
    private static final int SHADOW_MAP = 1024;
    private static final float SHADOW_DISTANCE = 25;

    private final Geometry sky;
    private final ViewPort view;
    private final DirectionalLightShadowRenderer shadows;
    private boolean shadowsOn;

    public Lighting(AssetManager assets, Node root, ViewPort view) {
        this.view = view;
        sky = Sky.make(assets);
        root.attachChild(sky);
        double[] toSun = Daylight.toSun();
        DirectionalLight sun = new DirectionalLight(new Vector3f((float) -toSun[0], (float) -toSun[1], (float) -toSun[2]), color(Daylight.sun()));
        root.addLight(sun);
        root.addLight(new AmbientLight(color(Daylight.sky())));
        shadows = new DirectionalLightShadowRenderer(assets, SHADOW_MAP, 2);
        shadows.setLight(sun);
        shadows.setShadowZExtend(SHADOW_DISTANCE);
        shadows.setShadowIntensity(Daylight.SHADOW);
        shadows.setRenderBackFacesShadows(false); // sides that look away from the sun are dark anyway
        shadows.setEdgeFilteringMode(EdgeFilteringMode.Bilinear);
        setShadows(true);
    }

    private static ColorRGBA color(float[] light) {
        return new ColorRGBA(light[0], light[1], light[2], 1);
    }

    public boolean hasShadows() {
        return shadowsOn;
    }

    /** Shadows cost a slow graphics card a third of its time. */
    public void setShadows(boolean on) {
        if (on != shadowsOn) {
            shadowsOn = on;
            if (on) {
                view.addProcessor(shadows);
            } else {
                view.removeProcessor(shadows);
            }
        }
    }

    /** What is behind everything. */
    public Spatial sky() {
        return sky;
    }

    /** Keeps the sky around the camera. */
    public void follow(Camera camera) {
        sky.setLocalTranslation(camera.getLocation());
    }
}
