// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.asset.AssetKey;
import com.jme3.asset.AssetLoadException;
import com.jme3.asset.AssetManager;
import com.jme3.asset.AssetNotFoundException;
import com.jme3.asset.DesktopAssetManager;
import com.jme3.asset.TextureKey;
import com.jme3.texture.Image;
import com.jme3.texture.Texture2D;
import com.jme3.texture.image.ColorSpace;
import com.jme3.util.BufferUtils;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.SEAR.files.UnreadablePicture;

/**
 * Asset manager for models that may lack pictures: a model without a readable picture is plain, like an object of the
 * grammar. Files beyond a limit are errors. One thread at a time.
 */
final class ModelAssets extends DesktopAssetManager {
    private static final Set<String> MATERIALS = Set.of("mtl", "material");
    private static final String MISSING = "there is no such file in assets";

    private List<String> leftOut = new ArrayList<>();

    ModelAssets(URL loaders) {
        super(loaders);
    }

    /** Returns and clears the list of parts that can't be shown, each with the reason. */
    List<String> takeLeftOut() {
        List<String> taken = leftOut;
        leftOut = new ArrayList<>();
        return taken;
    }

    /** Adds a reason why a model is not shown as its file says, if the manager lists them. */
    static void warn(AssetManager manager, String text) {
        if (manager instanceof ModelAssets) {
            ((ModelAssets) manager).leftOut.add(text);
        }
    }

    @Override
    public <T> T loadAsset(AssetKey<T> key) {
        if (key instanceof TextureKey) {
            return orPlain(key, () -> super.loadAsset(key));
        }
        if (!MATERIALS.contains(key.getExtension())) {
            return super.loadAsset(key);
        }
        try {
            return super.loadAsset(key);
        } catch (AssetNotFoundException e) {
            if (!key.getExtension().equals("material")) {       // which no OGRE mesh names
                leftOut.add("its materials " + key.getName() + " are left out: " + MISSING);
            }
            throw e;
        } catch (AssetLoadException e) {
            if (!(e.getCause() instanceof GuardedLoaders.UnreadableMaterials)) {
                throw e;
            }
            leftOut.add("its materials " + key.getName() + " are left out: " + e.getCause().getMessage());
            throw new AssetNotFoundException(key.getName());        // the reader continues without materials
        }
    }

    @Override
    public <T> T loadAssetFromStream(AssetKey<T> key, InputStream stream) {
        Supplier<T> load = () -> super.loadAssetFromStream(key, stream);
        return key instanceof TextureKey ? orPlain(key, load) : load.get();
    }

    @SuppressWarnings("unchecked")
    private <T> T orPlain(AssetKey<T> key, Supplier<T> load) {
        try {
            return load.get();
        } catch (RuntimeException e) {
            Throwable reason = e.getCause() instanceof IOException ? e.getCause() : e;
            if (reason instanceof IOException && !(reason instanceof UnreadablePicture)) {
                throw e;
            }
            leftOut.add("its picture " + key.getName() + " can't be shown: "
                + (e instanceof AssetNotFoundException ? MISSING : reason.getMessage().split("\n")[0]));
            Texture2D plain = new Texture2D(
                new Image(Image.Format.RGBA8, 1, 1, BufferUtils.createByteBuffer((byte) -1, (byte) -1, (byte) -1,
                (byte) -1), ColorSpace.sRGB));
            plain.setKey(key);
            return (T) plain;
        }
    }
}
