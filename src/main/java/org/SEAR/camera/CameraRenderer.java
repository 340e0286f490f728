package org.SEAR.camera;

import java.util.Deque;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.function.ObjIntConsumer;
import org.SEAR.POJOs.BrownLens;
import org.SEAR.POJOs.Camera;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.raycast.PictureBeams;

/**
 * Takes a camera's pictures: without errors, which come later. Large pictures are shared among the threads of a pool, strip by strip; the bytes
 * don't depend on how many there are. One picture at a time.
 */
public final class CameraRenderer {
    /** Smaller pictures are made by one thread: to share them takes longer. */
    private static final int WORTH_SHARING = 2_000;

    private final int width;
    private final int height;
    private final double near;
    private final double far;
    private final double pitch;
    private final PictureBeams beams;
    private final Deque<Painter> painters = new ConcurrentLinkedDeque<>();
    private WorkerPool workers = WorkerPool.ALONE;

    /** @param camera whose lens and size count */
    public CameraRenderer(Camera camera) {
        this(camera.getWidth(), camera.getHeight(), camera.getLens(), camera.getNear(), camera.getFar());
    }

    /**
     * An eye that is no camera's.
     *
     * @param width pixels of a row
     * @param height rows
     * @param near metres along the axis, nearer than which nothing is seen
     * @param far metres along the axis, farther than which nothing is seen
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

    /** Who makes large pictures; at first nobody but the thread that asks for one. */
    public void setWorkers(WorkerPool pool) {
        workers = pool;
    }

    /** Metres to the left of the axis, one metre ahead, of what a pixel sees. */
    public double left(int pixel) {
        return beams.left(pixel);
    }

    /** Metres above the axis, one metre ahead, of what a pixel sees. */
    public double up(int pixel) {
        return beams.up(pixel);
    }

    /** What is seen: 0xRRGGBB (sRGB) of each pixel, row by row from the top left. */
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

    /** How far what is seen is: metres along the axis, row by row from the top left; infinite where nothing is between near and far. */
    public float[] depths(RenderJob sight) {
        float[] picture = new float[width * height];
        strips((painter, strip) -> painter.depths(sight, strip, picture));
        return picture;
    }

    /** How warm what is seen is: degrees Celsius, row by row from the top left. */
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
