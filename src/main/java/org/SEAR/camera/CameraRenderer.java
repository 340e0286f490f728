// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import java.util.Deque;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.function.ObjIntConsumer;
import org.SEAR.POJOs.BrownLens;
import org.SEAR.POJOs.Camera;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.raycast.PictureBeams;

/**
 * Renders a camera's pictures without sensor errors. The threads of a pool share large pictures strip by strip; the
 * bytes don't depend on the number of threads. One picture at a time.
 */
public final class CameraRenderer {
    /** Number of pixels below which one thread renders a picture: sharing would take longer. */
    private static final int WORTH_SHARING = 2_000;

    private final int width;
    private final int height;
    private final double near;
    private final double far;
    private final double pitch;
    private final PictureBeams beams;
    private final Deque<Painter> painters = new ConcurrentLinkedDeque<>();
    private WorkerPool workers = WorkerPool.ALONE;

    /** @param camera source of lens and size */
    public CameraRenderer(Camera camera) {
        this(camera.getWidth(), camera.getHeight(), camera.getLens(), camera.getNear(), camera.getFar());
    }

    /**
     * Creates a renderer without a camera.
     *
     * @param width pixels per row
     * @param height rows
     * @param near distance along the axis below which nothing is visible, metres
     * @param far distance along the axis above which nothing is visible, metres
     */
    public CameraRenderer(int width, int height, BrownLens lens, double near, double far) {
        this.width = width;
        this.height = height;
        this.near = near;
        this.far = far;
        pitch = 1 / lens.getFocalLength();
        beams = beams(width, height, lens);
    }

    private static PictureBeams beams(int width, int height, BrownLens lens) {
        int count = width * height;
        double[] left = new double[count];
        double[] up = new double[count];
        double[] point = new double[2];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                lens.point(column, row, point);
                left[row * width + column] = 0.0 - point[0];
                up[row * width + column] = 0.0 - point[1];
            }
        }
        return new PictureBeams(width, left, up);
    }

    /** Sets the pool that renders large pictures. Default: the calling thread alone. */
    public void setWorkers(WorkerPool pool) {
        workers = pool;
    }

    /** Returns the distance to the left of the axis, one metre ahead, of a pixel's centre, metres. */
    public double left(int pixel) {
        return beams.left(pixel);
    }

    /** Returns the distance above the axis, one metre ahead, of a pixel's centre, metres. */
    public double up(int pixel) {
        return beams.up(pixel);
    }

    /** Returns the colours: 0xRRGGBB (sRGB) of each pixel, row by row from the top left. */
    public int[] colors(RenderJob sight) {
        int[] picture = new int[width * height];
        Appearance[] skins = skins(sight);
        boolean[] casting = new boolean[skins.length];
        for (int shape = 0; shape < casting.length; shape++) {
            casting[shape] = skins[shape].isCasting();
        }
        strips((painter, strip) -> painter.colors(sight, strip, skins, casting, picture));
        return picture;
    }

    /**
     * Returns the depths along the axis, metres, row by row from the top left; infinite where nothing is between near
     * and far.
     */
    public float[] depths(RenderJob sight) {
        float[] picture = new float[width * height];
        strips((painter, strip) -> painter.depths(sight, strip, picture));
        return picture;
    }

    /** Returns the temperatures, degrees Celsius, row by row from the top left. */
    public float[] temperatures(RenderJob sight) {
        float[] picture = new float[width * height];
        Appearance[] skins = skins(sight);
        strips((painter, strip) -> painter.temperatures(sight, strip, skins, picture));
        return picture;
    }

    private static Appearance[] skins(RenderJob sight) {
        Appearance[] skins = new Appearance[sight.scene.size()];
        for (int shape = 0; shape < skins.length; shape++) {
            skins[shape] = sight.looks.of(shape);
        }
        return skins;
    }

    private void strips(ObjIntConsumer<Painter> work) {
        WorkerPool pool = width * height >= WORTH_SHARING ? workers : WorkerPool.ALONE;
        pool.forEach(beams.tilesDown, strip -> {
            Painter free = painters.poll();
            Painter painter = free == null ? new Painter(beams, pitch, near, far) : free;
            work.accept(painter, strip);
            painters.push(painter);
        });
    }
}
