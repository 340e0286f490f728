// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;

import com.jme3.asset.AssetManager;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.scene.Node;
import com.jme3.system.JmeSystem;
import org.junit.Before;
import org.junit.Test;

/** Overlapping labels, without a display. */
public class LabelsTest {
    private final Camera camera = new Camera(640, 480);
    private Labels labels;

    @Before
    public void make() {
        AssetManager assets = JmeSystem.newAssetManager(JmeSystem.getPlatformAssetConfigURL());
        labels = new Labels(assets.loadFont("Interface/Fonts/Default.fnt"), new Materials(assets, false, warning -> {
            throw new AssertionError(warning);
        }), new Node("gui"));
        camera.setFrustumPerspective(50, 640f / 480, 0.1f, 100);
        camera.lookAtDirection(Vector3f.UNIT_Z, Vector3f.UNIT_Y);
        camera.update();
    }

    private void put(int count, float apart) {
        labels.begin();
        for (int i = 0; i < count; i++) {
            labels.put("sensor " + i, "sensor " + i + "  1.000 m", new Vector3f(0, i * apart, 5), camera);
        }
    }

    @Test
    public void ofManyLabelsAtOnePlaceThreeAreShown() {
        put(8, 0);
        for (int i = 0; i < 8; i++) {
            assertEquals("sensor " + i, i < 3 ? "sensor " + i + "  1.000 m" : null, labels.text("sensor " + i));
        }
    }

    @Test
    public void aHiddenLabelReturnsWhenThereIsSpace() {
        put(5, 0);
        assertNull(labels.text("sensor 4"));
        put(5, 0.5f);
        assertNotNull(labels.text("sensor 4"));
    }
}
