package org.SEAR.view.scene;

import com.jme3.asset.AssetManager;
import com.jme3.light.AmbientLight;
import com.jme3.light.DirectionalLight;
import com.jme3.material.Material;
import com.jme3.material.RenderState.FaceCullMode;
import com.jme3.math.ColorRGBA;
import com.jme3.math.FastMath;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.renderer.ViewPort;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.renderer.queue.RenderQueue.ShadowMode;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.scene.shape.Sphere;
import com.jme3.shadow.DirectionalLightShadowRenderer;
import com.jme3.shadow.EdgeFilteringMode;
import com.jme3.util.BufferUtils;
import java.nio.FloatBuffer;

/** Sky, sun, and the sun's shadows. There is no made-up ground: where nothing carries a robot, nothing is drawn. Window thread only. */
public final class Lighting {
    private static final ColorRGBA ZENITH = new ColorRGBA(0.26f, 0.47f, 0.77f, 1);
    private static final ColorRGBA HORIZON = new ColorRGBA(0.82f, 0.89f, 0.95f, 1);
    private static final ColorRGBA BELOW = new ColorRGBA(0.47f, 0.48f, 0.46f, 1);
    private static final ColorRGBA SUN = new ColorRGBA(0.82f, 0.79f, 0.72f, 1);
    private static final ColorRGBA AMBIENT = new ColorRGBA(0.50f, 0.53f, 0.58f, 1);
    private static final Vector3f SUNLIGHT = new Vector3f(-0.45f, -0.8f, 0.4f).normalizeLocal();
    private static final float SKY_RADIUS = 50;
    private static final int SHADOW_MAP = 1024;
    private static final float SHADOW_DISTANCE = 25;
    private static final float SHADOW_INTENSITY = 0.45f;

    private final Geometry sky;
    private final ViewPort view;
    private final DirectionalLightShadowRenderer shadows;
    private boolean shadowsOn;

    public Lighting(AssetManager assets, Node root, ViewPort view) {
        this.view = view;
        sky = sky(assets);
        root.attachChild(sky);
        DirectionalLight sun = new DirectionalLight(SUNLIGHT, SUN);
        root.addLight(sun);
        root.addLight(new AmbientLight(AMBIENT));
        shadows = new DirectionalLightShadowRenderer(assets, SHADOW_MAP, 2);
        shadows.setLight(sun);
        shadows.setShadowZExtend(SHADOW_DISTANCE);
        shadows.setShadowIntensity(SHADOW_INTENSITY);
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

    /** Keeps the sky around the camera. */
    public void follow(Camera camera) {
        sky.setLocalTranslation(camera.getLocation());
    }

    private static Geometry sky(AssetManager assets) {
        Sphere sphere = new Sphere(24, 24, SKY_RADIUS, false, true);
        FloatBuffer places = sphere.getFloatBuffer(Type.Position);
        FloatBuffer colors = BufferUtils.createFloatBuffer(4 * sphere.getVertexCount());
        ColorRGBA color = new ColorRGBA();
        for (int i = 0; i < sphere.getVertexCount(); i++) {
            float height = places.get(3 * i + 2) / SKY_RADIUS;
            if (height >= 0) {
                color.interpolateLocal(HORIZON, ZENITH, FastMath.sqrt(height));
            } else {
                color.interpolateLocal(HORIZON, BELOW, Math.min(1, -6 * height));
            }
            colors.put(color.r).put(color.g).put(color.b).put(1);
        }
        sphere.setBuffer(Type.Color, 4, colors);
        Geometry sky = new Geometry("sky", sphere);
        sky.rotate(-FastMath.HALF_PI, 0, 0);
        Material material = new Material(assets, "Common/MatDefs/Misc/Unshaded.j3md");
        material.setBoolean("VertexColor", true);
        material.getAdditionalRenderState().setDepthWrite(false);
        material.getAdditionalRenderState().setFaceCullMode(FaceCullMode.Off);
        sky.setMaterial(material);
        sky.setQueueBucket(Bucket.Sky);
        sky.setCullHint(CullHint.Never);
        sky.setShadowMode(ShadowMode.Off);
        return sky;
    }
}
