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
import org.SEAR.terrain.relief.GroundPicture;
import org.SEAR.terrain.relief.HillShade;

/** Sun, sky, and the sun's shadows. Window thread only. */
public final class Lighting {
    private static final ColorRGBA SUN = new ColorRGBA(0.82f, 0.79f, 0.72f, 1);
    private static final ColorRGBA AMBIENT = new ColorRGBA(0.50f, 0.53f, 0.58f, 1);
    private static final Vector3f SUNLIGHT = new Vector3f(-0.45f, -0.8f, 0.4f).normalizeLocal();
    /** Degrees by which the sun on landscapes stands lower: hills show their sides. */
    private static final double LOWER_SUN = 8;
    private static final int SHADOW_MAP = 1024;
    private static final float SHADOW_DISTANCE = 25;
    private static final float SHADOW_INTENSITY = 0.45f;

    private final Geometry sky;
    private final ViewPort view;
    private final DirectionalLightShadowRenderer shadows;
    private boolean shadowsOn;

    public Lighting(AssetManager assets, Node root, ViewPort view) {
        this.view = view;
        sky = Sky.make(assets);
        root.attachChild(sky);
        DirectionalLight sun = new DirectionalLight(SUNLIGHT, SUN);
        root.addLight(sun);
        root.addLight(new AmbientLight(AMBIENT));
        shadows = new DirectionalLightShadowRenderer(assets, SHADOW_MAP, 2);
        shadows.setLight(sun);
        shadows.setShadowZExtend(SHADOW_DISTANCE);
        shadows.setShadowIntensity(SHADOW_INTENSITY);
        shadows.setRenderBackFacesShadows(false); // sides that look away from the sun are dark anyway
        shadows.setEdgeFilteringMode(EdgeFilteringMode.Bilinear);
        setShadows(true);
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

    /** The light on a landscape, for pictures that have it in them. */
    public static GroundPicture.Light daylight() {
        Vector3f sun = SUNLIGHT.negate();
        double azimuth = Math.toDegrees(Math.atan2(sun.z, sun.x));
        HillShade shade = new HillShade(azimuth, Math.toDegrees(Math.asin(sun.y)) - LOWER_SUN);
        return new GroundPicture.Light(new float[] {AMBIENT.r, AMBIENT.g, AMBIENT.b}, new float[] {SUN.r, SUN.g, SUN.b}, shade);
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
