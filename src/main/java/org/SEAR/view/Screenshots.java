// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import com.jme3.post.SceneProcessor;
import com.jme3.profile.AppProfiler;
import com.jme3.renderer.Camera;
import com.jme3.renderer.RenderManager;
import com.jme3.renderer.ViewPort;
import com.jme3.renderer.queue.RenderQueue;
import com.jme3.texture.FrameBuffer;
import com.jme3.util.BufferUtils;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import org.SEAR.files.AtomicFile;

/**
 * Saves the window's picture to {@code sear-0001.png}, {@code sear-0002.png}, ... Reads on the window's thread, writes
 * on another.
 */
final class Screenshots implements SceneProcessor {
    private static final int PIXEL = 4;
    private static final int LAST = 9999;
    private final Path folder;
    private final ExecutorService writer;
    private final Consumer<String> report;
    private RenderManager manager;
    private int width;
    private int height;
    private boolean wanted;
    private Path named;

    /**
     * @param writer writes the files
     * @param tell receives messages, on the writer's thread
     */
    Screenshots(Path folder, ExecutorService writer, Consumer<String> tell) {
        this.folder = folder;
        this.writer = writer;
        this.report = tell;
    }

    /** Saves the present or next frame. */
    void take() {
        wanted = true;
    }

    /** Saves the present or next frame to this file. */
    void take(Path file) {
        wanted = true;
        named = file;
    }

    @Override
    public void postFrame(FrameBuffer out) {
        if (wanted) {
            wanted = false;
            Path file = named;
            named = null;
            ByteBuffer pixels = BufferUtils.createByteBuffer(width * height * PIXEL);
            manager.getRenderer().readFrameBuffer(out, pixels);
            int across = width;
            int down = height;
            writer.execute(() -> write(file, image(pixels, across, down)));
        }
    }

    private static BufferedImage image(ByteBuffer pixels, int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int at = ((height - 1 - y) * width + x) * PIXEL;
                image.setRGB(x, y, (pixels.get(at) & 0xff) << 16 | (pixels.get(at + 1) & 0xff) << 8
                    | pixels.get(at + 2) & 0xff);
            }
        }
        return image;
    }

    private void write(Path file, BufferedImage image) {
        Path target = file;
        try {
            target = file == null ? next() : file;
            Files.createDirectories(target.toAbsolutePath().getParent());
            AtomicFile.write(target, place -> ImageIO.write(image, "png", place.toFile()));
            report.accept("picture saved: " + target);
        } catch (IOException e) {
            report.accept("SEAR can't save the picture in " + folder + " (" + e.getMessage()
                + "); choose a writable folder");
        }
    }

    private Path next() throws IOException {
        for (int number = 1; number <= LAST; number++) {
            Path file = folder.resolve(String.format("sear-%04d.png", number));
            if (!Files.exists(file)) {
                return file;
            }
        }
        throw new IOException("there are " + LAST + " pictures already");
    }

    @Override
    public void initialize(RenderManager renderManager, ViewPort view) {
        manager = renderManager;
        Camera camera = view.getCamera();
        reshape(view, camera.getWidth(), camera.getHeight());
    }

    @Override
    public void reshape(ViewPort view, int newWidth, int newHeight) {
        width = newWidth;
        height = newHeight;
    }

    @Override
    public boolean isInitialized() {
        return manager != null;
    }

    @Override
    public void preFrame(float frameTime) {
        // nothing to do before a frame
    }

    @Override
    public void postQueue(RenderQueue queue) {
        // nothing to do before drawing
    }

    @Override
    public void cleanup() {
        manager = null;
    }

    @Override
    public void setProfiler(AppProfiler profiler) {
        // not profiled
    }
}
