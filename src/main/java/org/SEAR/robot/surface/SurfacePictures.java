// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import org.SEAR.files.Assets;

/** Pictures of a project's surfaces, each read when a sensor first looks. Simulation thread. */
final class SurfacePictures {
    private final Assets assets;
    private final Consumer<String> reported;
    private final Map<String, SurfacePicture> known = new HashMap<>();

    /** @param told takes one warning per picture that can't be read */
    SurfacePictures(Assets assets, Consumer<String> told) {
        this.assets = assets;
        this.reported = told;
    }

    /** Returns a picture; null if it can't be read. */
    SurfacePicture get(String path) {
        if (!known.containsKey(path)) {
            known.put(path, read(path));
        }
        return known.get(path);
    }

    private SurfacePicture read(String path) {
        try {
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(assets.readPicture(path)));
            if (image == null) {
                reported.accept("colour and line sensors can't read the picture " + path
                    + ", legal: .png, .jpg, .gif or .bmp");
            }
            return image == null ? null : new SurfacePicture(image);
        } catch (IOException e) {
            reported.accept("colour and line sensors can't read a picture: " + e.getMessage());
            return null;
        }
    }
}
