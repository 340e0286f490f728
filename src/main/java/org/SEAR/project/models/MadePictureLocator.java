// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetKey;
import com.jme3.asset.AssetLoadException;
import com.jme3.asset.AssetLocator;
import com.jme3.asset.AssetManager;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import org.SEAR.files.MadePictures;

/** Locates generated pictures. Any thread. */
public final class MadePictureLocator implements AssetLocator {
    @Override
    public void setRootPath(String rootPath) {
        // Generated pictures have no folder.
    }

    @Override
    @SuppressWarnings("rawtypes")
    public AssetInfo locate(AssetManager manager, AssetKey key) {
        try {
            byte[] file = MadePictures.of(key.getName());
            return file == null ? null : new AssetInfo(manager, key) {
                @Override
                public InputStream openStream() {
                    return new ByteArrayInputStream(file);
                }
            };
        } catch (IOException e) {
            throw new AssetLoadException("the picture " + key.getName() + " can't be made", e);
        }
    }
}
