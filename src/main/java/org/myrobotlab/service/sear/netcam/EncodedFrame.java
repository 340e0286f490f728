// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.util.EnumMap;
import java.util.Map;
import org.SEAR.camera.image.Jpeg;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.Picture;

/** A picture with its files, each encoded on first use. Any thread. */
final class EncodedFrame {
    private final CameraImage image;
    private final Map<Form, byte[]> files = new EnumMap<>(Form.class);

    EncodedFrame(CameraImage image) {
        this.image = image;
    }

    CameraImage getImage() {
        return image;
    }

    /** Returns the simulated time of the picture, seconds. */
    double getTime() {
        return image.getTime();
    }

    /** Returns the file; null if cameras of this kind lack the form. */
    synchronized byte[] file(Form form) {
        if (!form.fits(image.getKind())) {
            return null;
        }
        return files.computeIfAbsent(form == Form.STREAM ? Form.STILL : form == Form.STILL ? form : Form.EXACT,
            this::make);
    }

    private byte[] make(Form form) {
        if (form == Form.EXACT) {
            return image.png();
        }
        Picture picture = image.picture();
        return Jpeg.ofColors(picture.getWidth(), picture.getPixels());
    }
}
