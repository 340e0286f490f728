package org.SEAR.view.scene;

import com.jme3.asset.AssetManager;
import com.jme3.bounding.BoundingSphere;
import com.jme3.material.MatParamOverride;
import com.jme3.material.Material;
import com.jme3.math.Matrix4f;
import com.jme3.math.Vector3f;
import com.jme3.math.Vector4f;
import com.jme3.post.SceneProcessor;
import com.jme3.profile.AppProfiler;
import com.jme3.renderer.Camera;
import com.jme3.renderer.RenderManager;
import com.jme3.renderer.Renderer;
import com.jme3.renderer.ViewPort;
import com.jme3.renderer.queue.RenderQueue.ShadowMode;
import com.jme3.renderer.queue.RenderQueue;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.Spatial;
import com.jme3.shader.VarType;
import com.jme3.texture.FrameBuffer;
import com.jme3.texture.Image;
import com.jme3.texture.Texture2D;
import com.jme3.texture.Texture;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.camera.Daylight;

/**
 * The sun's shadows: a picture of how far the sun's light goes, in which {@code Surface.frag} and {@code Ground.frag} look up whether it reaches a
 * point. It has two squares, a fine one near the camera and a coarse one around that, and each is drawn again only when something in it has moved or
 * the camera has gone on; what stands still costs nothing. Window thread only.
 */
final class SunShadow implements SceneProcessor {
    /** Of a side of a square. */
    private static final int PIXELS = 1024;
    /** Half the side of the coarse square, metres, and how many times the fine one's that is; as {@code SunShadow.glsllib} has it. */
    private static final float REACH = 22;
    private static final float COARSER = 5;
    /** Metres ahead of the camera where the squares' middles are, as shares of their half side. */
    private static final float AHEAD = 0.7f;
    /** A square's middle goes by such shares of its half side, whole pixels: shadows don't swim, nor are drawn for each centimetre. */
    private static final float STRIDE = 1f / 8;
    /** Metres before and behind the middle from which things cast shadows. */
    private static final float DEPTH = 200;
    /** Depth by which what casts a shadow is put farther off, so that it casts none on itself: by its slope, and steps of the depth. */
    private static final float SLOPE_OFF = 2;
    private static final float STEPS_OFF = 4;
    /** Pictures for which a movement may wait until it is seen in the coarse square, and in both where there is no time. */
    private static final int TIMEOUT = 3;

    private final Node root;
    private final Material caster;
    private final Square fine = new Square(0, REACH / COARSER);
    private final Square coarse = new Square(1, REACH);
    private final Vector3f sunlight;
    /** Two axes across the sunlight. */
    private final Vector3f across;
    private final Vector3f along;
    private final List<Caster> casters = new ArrayList<>();
    private final Matrix4f view = new Matrix4f();
    private final Vector4f squares = new Vector4f();
    private final MatParamOverride mapOverride = new MatParamOverride(VarType.Texture2D, "SunShadow", null);
    private final MatParamOverride viewOverride = new MatParamOverride(VarType.Matrix4, "SunView", view);
    private final MatParamOverride squaresOverride = new MatParamOverride(VarType.Vector4, "SunSquares", squares);
    private final MatParamOverride takenOverride = new MatParamOverride(VarType.Float, "SunTaken", Daylight.SHADOW);
    private final FrameBuffer buffer = new FrameBuffer(2 * PIXELS, PIXELS, 1);
    private RenderManager manager;
    private ViewPort port;
    private boolean hurried;
    private int known;
    private int drawn;

    SunShadow(AssetManager assets, Node root, Vector3f sunlight) {
        this.root = root;
        this.sunlight = sunlight.normalize();
        across = this.sunlight.cross(Vector3f.UNIT_Y).normalizeLocal();
        along = across.cross(this.sunlight);
        caster = new Material(assets, "Common/MatDefs/Shadow/PreShadow.j3md");
        caster.getAdditionalRenderState().setPolyOffset(SLOPE_OFF, STEPS_OFF);
        Texture2D map = map();
        buffer.setDepthTarget(FrameBuffer.FrameBufferTarget.newTarget(map));
        mapOverride.setValue(map);
    }

    private static Texture2D map() {
        Texture2D map = new Texture2D(2 * PIXELS, PIXELS, Image.Format.Depth24);
        map.setShadowCompareMode(Texture.ShadowCompareMode.LessOrEqual);
        map.setMagFilter(Texture.MagFilter.Bilinear);
        map.setMinFilter(Texture.MinFilter.BilinearNoMipMaps);
        return map;
    }

    /** For a machine that has no time: what moves has a new shadow in each third picture only. */
    void hurry() {
        hurried = true;
    }

    boolean isHurried() {
        return hurried;
    }

    /** Has them seen in a view, from its next picture on. */
    void showIn(ViewPort viewPort) {
        viewPort.addProcessor(this);
        root.addMatParamOverride(mapOverride);
        root.addMatParamOverride(viewOverride);
        root.addMatParamOverride(squaresOverride);
        root.addMatParamOverride(takenOverride);
    }

    void hideIn(ViewPort viewPort) {
        viewPort.removeProcessor(this);
        root.removeMatParamOverride(mapOverride);
        root.removeMatParamOverride(viewOverride);
        root.removeMatParamOverride(squaresOverride);
        root.removeMatParamOverride(takenOverride);
    }

    /** Things drawn into the map since the beginning. */
    int drawn() {
        return drawn;
    }

    @Override
    public void initialize(RenderManager renderManager, ViewPort viewPort) {
        manager = renderManager;
        port = viewPort;
    }

    @Override
    public void cleanup() {
        port = null;
    }

    @Override
    public boolean isInitialized() {
        return port != null;
    }

    @Override
    public void reshape(ViewPort viewPort, int width, int height) {
        // the map does not depend on the window's size
    }

    @Override
    public void preFrame(float frameTime) {
        // everything is done when all is in its place
    }

    @Override
    public void postQueue(RenderQueue queue) {
        known = 0;
        look(root);
        for (int i = known; i < casters.size(); i++) {
            touch(casters.get(i));
        }
        casters.subList(known, casters.size()).clear();
        fine.aim(port.getCamera());
        coarse.aim(port.getCamera());
        boolean redrawn = fine.draw(hurried ? TIMEOUT : 1);
        redrawn |= coarse.draw(TIMEOUT);
        if (redrawn) {
            Renderer renderer = manager.getRenderer();
            renderer.setFrameBuffer(port.getOutputFrameBuffer());
            manager.setForcedMaterial(null);
            manager.setCamera(port.getCamera(), false);
        }
        squares.set(fine.x / REACH, fine.y / REACH, coarse.x / REACH, coarse.y / REACH);
        squaresOverride.setValue(squares);
        for (int axis = 0; axis < 3; axis++) {
            view.set(0, axis, across.get(axis) / REACH);
            view.set(1, axis, along.get(axis) / REACH);
            view.set(2, axis, sunlight.get(axis) / (2 * DEPTH));
        }
        view.set(2, 3, 0.5f - coarse.depth / (2 * DEPTH));
        viewOverride.setValue(view);
    }

    /** Finds what casts shadows, and what of it has moved. */
    private void look(Spatial spatial) {
        if (spatial.getLocalCullHint() == CullHint.Always) {
            return;
        }
        if (spatial instanceof Node) {
            List<Spatial> children = ((Node) spatial).getChildren();
            for (int i = 0; i < children.size(); i++) {
                look(children.get(i));
            }
        } else if (spatial.getShadowMode() == ShadowMode.Cast || spatial.getShadowMode() == ShadowMode.CastAndReceive) {
            Geometry geometry = (Geometry) spatial;
            if (known == casters.size()) {
                casters.add(new Caster());
            }
            Caster one = casters.get(known++);
            if (one.geometry != geometry || !one.place.equals(geometry.getWorldMatrix())) {
                touch(one);
                one.set(geometry);
                touch(one);
            }
        }
    }

    private void touch(Caster one) {
        if (one.geometry != null) {
            fine.touch(one);
            coarse.touch(one);
        }
    }

    @Override
    public void postFrame(FrameBuffer out) {
        // nothing is left to be done
    }

    @Override
    public void setProfiler(AppProfiler profiler) {
        // nobody profiles it
    }

    /** A thing that casts a shadow, where it was last. */
    private final class Caster {
        private final Matrix4f place = new Matrix4f();
        private Geometry geometry;
        private float x;
        private float y;
        private float radius;

        void set(Geometry now) {
            geometry = now;
            place.set(now.getWorldMatrix());
            BoundingSphere sphere = new BoundingSphere(0, now.getWorldBound().getCenter());
            sphere.mergeLocal(now.getWorldBound());
            x = across.dot(sphere.getCenter());
            y = along.dot(sphere.getCenter());
            radius = sphere.getRadius();
        }
    }

    /** A part of the map. */
    private final class Square {
        private final int number;
        private final float reach;
        private final Camera camera = new Camera(2 * PIXELS, PIXELS);
        private final Vector3f middle = new Vector3f();
        /** Of the middle, metres as the sun sees it. */
        private float x = Float.NaN;
        private float y;
        private float depth;
        private boolean stale;
        private boolean moved;
        private int waited;

        Square(int number, float reach) {
            this.number = number;
            this.reach = reach;
            camera.setParallelProjection(true);
            camera.setFrustum(0, 2 * DEPTH, -reach, reach, reach, -reach);
            camera.setViewPort(number / 2f, (number + 1) / 2f, 0, 1);
        }

        /** Lies ahead of a camera. */
        void aim(Camera eye) {
            middle.set(eye.getDirection()).multLocal(AHEAD * reach).addLocal(eye.getLocation());
            float stride = STRIDE * reach;
            float newX = Math.round(across.dot(middle) / stride) * stride;
            float newY = Math.round(along.dot(middle) / stride) * stride;
            float coarseStride = STRIDE * REACH;
            float newDepth = Math.round(sunlight.dot(eye.getLocation()) / coarseStride) * coarseStride;
            stale |= newX != x || newY != y || newDepth != depth;
            x = newX;
            y = newY;
            depth = newDepth;
        }

        boolean sees(Caster one) {
            return Math.abs(one.x - x) < reach + one.radius && Math.abs(one.y - y) < reach + one.radius;
        }

        void touch(Caster one) {
            moved |= sees(one);
        }

        /** @return whether it had to be drawn */
        boolean draw(int timeout) {
            waited++;
            if (!stale && !(moved && waited >= timeout)) {
                return false;
            }
            stale = false;
            moved = false;
            waited = 0;
            middle.set(across).multLocal(x).addLocal(along.mult(y)).addLocal(sunlight.mult(depth - DEPTH));
            camera.setLocation(middle);
            camera.setAxes(across.negate(), along, sunlight);
            camera.update();
            Renderer renderer = manager.getRenderer();
            renderer.setFrameBuffer(buffer);
            manager.setCamera(camera, false);
            renderer.setClipRect(number * PIXELS, 0, PIXELS, PIXELS);
            renderer.clearBuffers(false, true, false);
            manager.setForcedMaterial(caster);
            for (int i = 0; i < casters.size(); i++) {
                if (sees(casters.get(i))) {
                    manager.renderGeometry(casters.get(i).geometry);
                    drawn++;
                }
            }
            renderer.clearClipRect();
            return true;
        }
    }
}
