// SPDX-License-Identifier: Apache-2.0
package org.SEAR.assets;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/** Picture computed point by point, with four samples per pixel. */
final class ProceduralPicture {
    /** Returns a colour for each point; u to the right and v upwards, both 0 to 1. */
    interface Painter {
        Rgb at(double u, double v);
    }

    private static final double[] SAMPLES = {0.25, 0.75};
    private final BufferedImage image;

    ProceduralPicture(int width, int height, Painter painter) {
        image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                Rgb sum = Rgb.BLACK;
                for (double dx : SAMPLES) {
                    for (double dy : SAMPLES) {
                        sum = sum.plus(painter.at((x + dx) / width, 1 - (y + dy) / height));
                    }
                }
                image.setRGB(x, y, sum.times(0.25).toInt());
            }
        }
    }

    /** Writes the picture in the format of the file's ending, png or jpg. */
    void write(Path file) throws IOException {
        Files.createDirectories(file.getParent());
        String name = file.getFileName().toString();
        String format = name.substring(name.lastIndexOf('.') + 1);
        if (!ImageIO.write(image, format, file.toFile())) {
            throw new IOException("this Java can't write " + format);
        }
    }
}
