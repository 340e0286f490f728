// SPDX-License-Identifier: Apache-2.0
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
 * Shadow map of the sun, which {@code Surface.frag} and {@code Ground.frag} sample. It has a fine square near the
 * camera and a coarse one around it. Each is redrawn only after an object in it or the camera has moved, so static
 * scenes cost nothing. Window thread only.
 */
final class SunShadow implements SceneProcessor {
    /** Side of a square, pixels. */
    private static final int PIXELS = 1024;
    /** Half side of the coarse square, metres, and its ratio to the fine one; as in {@code SunShadow.glsllib}. */
    private static final float REACH = 22;
    private static final float COARSER = 5;
    /** Distance of the squares' centres ahead of the camera, as a share of their half side. */
    private static final float AHEAD = 0.7f;
    /**
     * Step of a square's centre, as a share of its half side; a whole number of pixels. Prevents swimming shadows and
     * frequent redraws.
     */
    private static final float STRIDE = 1f / 8;
    /** Depth range of shadow casters before and behind the centre, metres. */
    private static final float DEPTH = 200;
    /** Depth bias of casters against self-shadowing: by slope, and in depth steps. */
    private static final float SLOPE_OFF = 2;
    private static final float STEPS_OFF = 4;
    /** Frames by which a movement may be delayed in the coarse square; on slow machines also in the fine one. */
    private static final int TIMEOUT = 3;

    private final Node root;
    private final Material caster;
    private final Square fine = new Square(0, REACH / COARSER);
    private final Square coarse = new Square(1, REACH);
    private final Vector3f sunlight;
    /** Two axes perpendicular to the sunlight. */
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

    /** Reduces shadow updates of moving objects to every third frame, for slow machines. */
    void hurry() {
        hurried = true;
    }

    boolean isHurried() {
        return hurried;
    }

    /** Enables shadows in a view from its next frame on. */
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

    /** Returns the number of objects drawn into the map so far. */
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
        // postQueue() does everything after objects have moved
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

    /** Collects shadow casters and marks moved ones. */
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
        // nothing to finish
    }

    @Override
    public void setProfiler(AppProfiler profiler) {
        // not profiled
    }

    /** Shadow caster at its latest position. */
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

    /** Square of the map. */
    private final class Square {
        private final int number;
        private final float reach;
        private final Camera camera = new Camera(2 * PIXELS, PIXELS);
        private final Vector3f middle = new Vector3f();
        /** Centre in the sun's frame, metres. */
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

        /** Moves the square ahead of a camera. */
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

        /** @return whether the square was redrawn */
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
