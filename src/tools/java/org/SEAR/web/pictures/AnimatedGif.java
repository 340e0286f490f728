// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/** Animated GIF in an endless loop. Java chooses the colours of a frame, which stores changed pixels. One thread. */
final class AnimatedGif {
    private static final String SCREEN = "javax_imageio_gif_stream_1.0";
    private static final String FORMAT = "javax_imageio_gif_image_1.0";
    /** Loop count for an endless loop in browsers. */
    private static final byte[] FOR_EVER = {1, 0, 0};

    private final List<int[]> pictures = new ArrayList<>();
    private final List<Integer> hundredths = new ArrayList<>();
    private int width;
    private int height;

    /**
     * Adds a picture of the same size as the previous ones.
     * @param time for which it is shown, hundredths of a second
     */
    void add(BufferedImage picture, int time) {
        width = picture.getWidth();
        height = picture.getHeight();
        int[] pixels = picture.getRGB(0, 0, width, height, null, 0, width);
        int last = pictures.size() - 1;
        if (last >= 0 && Arrays.equals(pictures.get(last), pixels)) {
            hundredths.set(last, hundredths.get(last) + time);
        } else {
            pictures.add(pixels);
            hundredths.add(time);
        }
    }

    void write(Path file) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
        Files.deleteIfExists(file);
        try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
            writer.setOutput(out);
            writer.prepareWriteSequence(screen(writer));
            for (int i = 0; i < pictures.size(); i++) {
                writeChange(writer, i == 0 ? null : pictures.get(i - 1), pictures.get(i), hundredths.get(i));
            }
            writer.endWriteSequence();
        } finally {
            writer.dispose();
        }
    }

    /** Returns the size of all pictures. */
    private IIOMetadata screen(ImageWriter writer) throws IOException {
        IIOMetadata metadata = writer.getDefaultStreamMetadata(null);
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(SCREEN);
        IIOMetadataNode size = child(root, "LogicalScreenDescriptor");
        size.setAttribute("logicalScreenWidth", Integer.toString(width));
        size.setAttribute("logicalScreenHeight", Integer.toString(height));
        metadata.setFromTree(SCREEN, root);
        return metadata;
    }

    private void writeChange(ImageWriter writer, int[] before, int[] now, int time) throws IOException {
        Rectangle part = changed(before, now);
        BufferedImage image = new BufferedImage(part.width, part.height, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < part.height; y++) {
            for (int x = 0; x < part.width; x++) {
                int at = (part.y + y) * width + part.x + x;
                image.setRGB(x, y, before != null && before[at] == now[at] ? 0 : now[at]);
            }
        }
        IIOMetadata metadata = writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(image), null);
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
        IIOMetadataNode descriptor = child(root, "ImageDescriptor");
        descriptor.setAttribute("imageLeftPosition", Integer.toString(part.x));
        descriptor.setAttribute("imageTopPosition", Integer.toString(part.y));
        IIOMetadataNode control = child(root, "GraphicControlExtension");
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("delayTime", Integer.toString(time));
        IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
        loop.setAttribute("applicationID", "NETSCAPE");
        loop.setAttribute("authenticationCode", "2.0");
        loop.setUserObject(FOR_EVER);
        child(root, "ApplicationExtensions").appendChild(loop);
        metadata.setFromTree(FORMAT, root);
        writer.writeToSequence(new IIOImage(image, null, metadata), null);
    }

    private static IIOMetadataNode child(IIOMetadataNode root, String name) {
        for (int i = 0; i < root.getLength(); i++) {
            if (root.item(i).getNodeName().equals(name)) {
                return (IIOMetadataNode) root.item(i);
            }
        }
        IIOMetadataNode child = new IIOMetadataNode(name);
        root.appendChild(child);
        return child;
    }

    /** Returns the bounds of all differing pixels; a single pixel if none differs. */
    private Rectangle changed(int[] before, int[] now) {
        if (before == null) {
            return new Rectangle(width, height);
        }
        Rectangle all = null;
        for (int i = 0; i < now.length; i++) {
            if (before[i] != now[i]) {
                Rectangle one = new Rectangle(i % width, i / width, 1, 1);
                all = all == null ? one : all.union(one);
            }
        }
        return all == null ? new Rectangle(1, 1) : all;
    }
}
