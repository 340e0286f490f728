// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetLoader;
import com.jme3.asset.AssetManager;
import com.jme3.texture.Image;
import com.jme3.texture.image.ColorSpace;
import com.jme3.texture.plugins.AWTLoader;
import com.jme3.texture.plugins.DDSLoader;
import com.jme3.texture.plugins.HDRLoader;
import com.jme3.texture.plugins.PFMLoader;
import com.jme3.texture.plugins.TGALoader;
import com.jme3.texture.plugins.ktx.KTXLoader;
import com.jme3.util.BufferUtils;
import java.io.IOException;
import java.io.InputStream;
import java.util.Locale;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PictureSize;

/** Loads pictures after checking their size: a few kilobytes may unpack to gigabytes. */
final class PictureLoader {
    private static final String[] ENDINGS = {"png", "jpg", "jpeg", "gif", "bmp", "tga", "dds", "hdr"};

    private PictureLoader() {
    }

    /**
     * Replaces the unguarded loaders.
     *
     * @param pixels whether the pictures are needed
     */
    static void register(AssetManager manager, boolean pixels) {
        manager.unregisterLoader(PFMLoader.class);
        manager.unregisterLoader(KTXLoader.class);
        manager.registerLoader(pixels ? Guarded.class : Unseen.class, ENDINGS);
    }

    private static byte[] checked(AssetInfo info) throws IOException {
        String name = info.getKey().getName();
        byte[] bytes;
        try (InputStream in = info.openStream()) {
            bytes = in.readNBytes(FileLimits.MAX_PICTURE + 1);
        }
        return PictureSize.checked(bytes, name);
    }

    private static String ending(AssetInfo info) {
        return info.getKey().getExtension().toLowerCase(Locale.ROOT);
    }

    /** Loader of pictures with their pixels. */
    public static final class Guarded implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            AssetInfo checked = new GuardedLoaders.Checked(info, checked(info));
            switch (ending(info)) {
                case "tga":
                    return new TGALoader().load(checked);
                case "dds":
                    return new DDSLoader().load(checked);
                case "hdr":
                    return new HDRLoader().load(checked);
                default:
                    return new AWTLoader().load(checked);
            }
        }
    }

    /** Loader for physics and beams, which checks pictures but does not unpack them. */
    public static final class Unseen implements AssetLoader {
        @Override
        public Object load(AssetInfo info) throws IOException {
            checked(info);
            return new Image(Image.Format.RGBA8, 1, 1, BufferUtils.createByteBuffer(4), ColorSpace.sRGB);
        }
    }
}
