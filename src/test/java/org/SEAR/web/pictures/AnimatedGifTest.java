// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** An animated GIF contains everything drawn and stores only changes. */
public class AnimatedGifTest {
    private static final int WIDTH = 60;
    private static final int HEIGHT = 40;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private static BufferedImage picture(int x, Color color) {
        BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = picture.createGraphics();
        pen.setColor(Color.WHITE);
        pen.fillRect(0, 0, WIDTH, HEIGHT);
        pen.setColor(color);
        pen.fillRect(x, 10, 5, 5);
        pen.dispose();
        return picture;
    }

    private static String of(ImageReader reader, int index, String node, String attribute) throws Exception {
        IIOMetadataNode root = (IIOMetadataNode) reader.getImageMetadata(index)
            .getAsTree("javax_imageio_gif_image_1.0");
        return ((IIOMetadataNode) root.getElementsByTagName(node).item(0)).getAttribute(attribute);
    }

    @Test
    public void framesStoreOnlyChanges() throws Exception {
        AnimatedGif gif = new AnimatedGif();
        gif.add(picture(10, Color.RED), 20);
        gif.add(picture(10, Color.RED), 30);
        gif.add(picture(12, Color.BLUE), 7);
        Path file = folder.getRoot().toPath().resolve("a.gif");
        gif.write(file);
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            reader.setInput(in);
            assertEquals("the same picture once", 2, reader.getNumImages(true));
            assertEquals("50", of(reader, 0, "GraphicControlExtension", "delayTime"));
            assertEquals("7", of(reader, 1, "GraphicControlExtension", "delayTime"));
            BufferedImage first = reader.read(0);
            BufferedImage second = reader.read(1);
            assertEquals(WIDTH, first.getWidth());
            assertEquals(0xffff0000, first.getRGB(11, 12));
            assertEquals(0xffffffff, first.getRGB(0, 0));
            assertEquals("10", of(reader, 1, "ImageDescriptor", "imageLeftPosition"));
            assertEquals("10", of(reader, 1, "ImageDescriptor", "imageTopPosition"));
            assertEquals(7, second.getWidth());
            assertEquals(5, second.getHeight());
            assertEquals("gone", 0xffffffff, second.getRGB(0, 0));
            assertEquals("come", 0xff0000ff, second.getRGB(6, 4));
            assertTrue("shown for ever", of(reader, 0, "ApplicationExtension", "applicationID").equals("NETSCAPE"));
        } finally {
            reader.dispose();
        }
    }
}
