// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import com.jme3.math.ColorRGBA;
import com.jme3.renderer.Camera;
import com.jme3.renderer.RenderManager;
import com.jme3.renderer.ViewPort;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;

/**
 * Draws everything beyond the main view's far plane first, with a separate depth range: one depth buffer is too coarse
 * for wheels and mountains. Also draws the sky. Window thread only.
 */
public final class FarView {
    /** Far plane, metres: beyond the far corner of the largest world. */
    static final float FAR = 400_000;
    /** Near plane as a share of the main view's far plane; the two views overlap. */
    private static final float OVERLAP = 0.97f;

    /** Scale that puts the sky beyond the main view's far plane. */
    private static final float SKY = 100;

    private final ViewPort main;
    private final Camera far;
    private final Node sky = new Node("far sky");

    /**
     * @param scene drawn by the main view
     * @param background moved out of the scene
     */
    public FarView(RenderManager manager, ViewPort main, Node scene, Spatial background) {
        this.main = main;
        far = main.getCamera().clone();
        sky.attachChild(background);
        background.setLocalScale(SKY);
        ViewPort view = manager.createPreView("far", far);
        view.setClearFlags(true, true, true);
        view.setBackgroundColor(ColorRGBA.Black);
        view.attachScene(sky);
        view.attachScene(scene);
        main.setClearFlags(false, true, true);
    }

    /** Follows the main view's camera. */
    public void update(float frameTime) {
        Camera near = main.getCamera();
        if (far.getWidth() != near.getWidth() || far.getHeight() != near.getHeight()) {
            far.resize(near.getWidth(), near.getHeight(), false);
        }
        float scale = OVERLAP * near.getFrustumFar() / near.getFrustumNear();
        far.setFrustum(OVERLAP * near.getFrustumFar(), FAR, scale * near.getFrustumLeft(),
            scale * near.getFrustumRight(), scale * near.getFrustumTop(), scale * near.getFrustumBottom());
        far.setFrame(near.getLocation(), near.getRotation());
        sky.updateLogicalState(frameTime);
        sky.updateGeometricState();
    }
}
