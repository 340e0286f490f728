// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.jme3.asset.AssetManager;
import com.jme3.system.JmeSystem;
import com.jme3.texture.Texture;
import java.net.URL;
import org.SEAR.POJOs.Floor;
import org.SEAR.files.Assets;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.models.ModelLoader;
import org.junit.Rule;
import org.junit.Test;

/** Textures of surfaces, without a display. */
public class MaterialsTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private Texture floor(boolean fine) {
        URL config = JmeSystem.getPlatformAssetConfigURL();
        AssetManager manager = JmeSystem.newAssetManager(config);
        ModelLoader.prepare(manager, new Assets(project.folder()));
        Materials materials = new Materials(manager, fine, warning -> {
            throw new AssertionError(warning);
        });
        return materials.surface(new Floor("floor", 10, 10)).getTextureParam("DiffuseMap").getTextureValue();
    }

    @Test
    public void aGraphicsCardGetsMipmapsAndAnAnisotropicFilterSoftwareOpenGlDoesNot() {
        Texture fine = floor(true);
        assertTrue(fine.getMinFilter().usesMipMapLevels());
        assertEquals(8, fine.getAnisotropicFilter());
        Texture quick = floor(false);
        assertFalse(quick.getMinFilter().usesMipMapLevels());
        assertEquals(0, quick.getAnisotropicFilter());
    }
}
