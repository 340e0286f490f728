package org.myrobotlab.service.sear.netcam;

import java.util.EnumMap;
import java.util.Map;
import org.SEAR.camera.image.Jpeg;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.Picture;

/** One picture as files, each made once, when it is first asked for. Any thread. */
final class EncodedFrame {
    private final CameraImage image;
    private final Map<Form, byte[]> files = new EnumMap<>(Form.class);

    EncodedFrame(CameraImage image) {
        this.image = image;
    }

    /** The picture. */
    CameraImage getImage() {
        return image;
    }

    /** Simulated seconds at which it was taken. */
    double getTime() {
        return image.getTime();
    }

    /** A file; null if cameras of this kind have none of that form. */
    synchronized byte[] file(Form form) {
        if (!form.fits(image.getKind())) {
            return null;
        }
        return files.computeIfAbsent(form == Form.STREAM ? Form.STILL : form == Form.STILL ? form : Form.EXACT, this::make);
    }

    private byte[] make(Form form) {
        if (form == Form.EXACT) {
            return image.png();
        }
        Picture picture = image.picture();
        return Jpeg.ofColors(picture.getWidth(), picture.getPixels());
    }
}
