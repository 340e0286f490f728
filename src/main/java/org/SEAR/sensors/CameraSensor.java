// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.List;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.SearObject;
import org.SEAR.camera.CameraRenderer;
import org.SEAR.camera.RenderJob;
import org.SEAR.camera.image.Exposure;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.raycast.BeamScene;

/**
 * Pictures at the camera's rate in simulated time. A reading is the last picture that was due or, before the first, a
 * picture of the present moment.
 *
 * <p>When a picture is due, the sensor stores only the poses of all objects, which costs almost nothing. It renders the
 * picture of that moment when it is read. A camera without readers therefore does not slow the simulation down, and
 * readers do not affect the bytes.
 */
public final class CameraSensor extends Sensor<CameraImage> {
    private static final int SHOT = 11;
    private static final int READ = 12;
    private static final int DEPTH = 13;
    private static final int HEAT = 14;
    private static final int CHANNELS = 3;
    private static final double FULL = 255;

    private final Camera camera;
    private final Exposure exposure;
    private CounterRandom random;
    private CameraRenderer eye;
    private double[] poses = {};
    private final double[] drifts = new double[CHANNELS];
    private Pose place;
    private long due = -1;
    private double dueTime;
    /** Copy of the world at the time of the last picture that was due, if the world has moved on. */
    private BeamScene past;
    /** The world of the last picture, and the robot hidden in it. */
    private BeamScene seen;
    private int unseen;
    private CameraImage image;
    private long imageStep = -1;

    /** @param seed random seed of the simulation */
    public CameraSensor(Camera parameters, long seed) {
        super(parameters, seed, CHANNELS);
        camera = parameters;
        exposure = new Exposure(parameters);
        random = new CounterRandom(seed, parameters.getFullName());
    }

    @Override
    public boolean takesPictures() {
        return true;
    }

    @Override
    public List<String> names(Truth truth) {
        return CameraImage.names(camera.getKind());
    }

    @Override
    public void reseed(long seed) {
        super.reseed(seed);
        random = new CounterRandom(seed, camera.getFullName());
    }

    /** Stores all poses when a picture is due. */
    @Override
    public void track(Truth truth) {
        super.track(truth);
        if (number(truth.step(), truth) > number(truth.step() - 1, truth)) {
            BeamScene seen = scene(truth);
            int size = BeamScene.POSE * seen.size();
            if (poses.length != size) {
                poses = new double[size];
            }
            seen.poses(poses);
            place = pose(truth);
            due = truth.step();
            dueTime = truth.time();
            noteDrifts();
        }
    }

    private void noteDrifts() {
        for (int channel = 0; channel < CHANNELS; channel++) {
            drifts[channel] = errors.drift(channel);
        }
    }

    /** Returns how many pictures have been due up to a step. */
    private long number(long step, Truth truth) {
        return TimeStep.periods(step * truth.stepLength(), camera.getRate());
    }

    /** Objects hidden from beams are visible to cameras, except for depth cameras, which measure by beams. */
    private BeamScene scene(Truth truth) {
        return Camera.DEPTH.equals(camera.getKind()) ? truth.scene() : truth.sight();
    }

    @Override
    public void reset() {
        super.reset();
        due = -1;
        imageStep = -1;
        image = null;
    }

    @Override
    protected CameraImage measure(Truth truth) {
        long wanted = due < 0 ? truth.step() : due;
        if (image == null || imageStep != wanted) {
            image = wanted == truth.step() ? take(truth, scene(truth), pose(truth), truth.time())
                : take(truth, before(scene(truth)), place, dueTime);
            imageStep = wanted;
        }
        return image;
    }

    /**
     * Returns the current distance along the axis of what a pixel of the last picture shows, metres. Infinite without
     * anything in range; NaN without a picture. Simulation thread.
     */
    public double depth(int pixel) {
        if (image == null) {
            return Double.NaN;
        }
        double left = eye.left(pixel);
        double up = eye.up(pixel);
        double length = Math.sqrt(1 + left * left + up * up);    // length of a ray per metre along the axis
        Pose from = image.getPose();
        double[] ahead = from.rotate(left / length, up / length, 1 / length);
        double[] start = from.transform(camera.getNear() * left, camera.getNear() * up, camera.getNear());
        double range = (camera.getFar() - camera.getNear()) * length;
        BeamScene scene = due < 0 ? seen : before(seen);
        return camera.getNear() + scene.cast(start[0], start[1], start[2], ahead[0], ahead[1], ahead[2], range, unseen,
            null) / length;
    }

    private BeamScene before(BeamScene now) {
        if (past == null) {
            past = now.copy();
        }
        past.setPoses(poses);
        return past;
    }

    private CameraImage take(Truth truth, BeamScene scene, Pose from, double time) {
        if (eye == null) {
            eye = new CameraRenderer(camera);
        }
        eye.setWorkers(truth.workers());
        long step = due < 0 ? truth.step() : due;
        if (due < 0) {
            noteDrifts();
        }
        seen = scene;
        unseen = camera.isSeesOwnRobot() ? BeamScene.WORLD : truth.owner();
        RenderJob sight = new RenderJob(scene, truth.looks(), from, unseen);
        int[] pixels = null;
        float[] values = null;
        switch (camera.getKind()) {
            case Camera.DEPTH:
                values = eye.depths(sight);
                measureDepths(values, step);
                break;
            case Camera.INFRARED:
                values = eye.temperatures(sight);
                measureHeat(values, step);
                break;
            default:
                pixels = eye.colors(sight);
                exposure.expose(pixels, (reading, number) -> random.normal(step, reading ? READ : SHOT, number));
                measureColors(pixels, step);
        }
        CameraRenderer lens = eye;
        return new CameraImage(camera, time, from, new CameraImage.Rays() {
            @Override
            public double left(int pixel) {
                return lens.left(pixel);
            }

            @Override
            public double up(int pixel) {
                return lens.up(pixel);
            }
        }, pixels, values);
    }

    /** A noisy depth below near or above far becomes no return; no return stays no return. */
    private void measureDepths(float[] depths, long step) {
        double noise = camera.getDepthNoise();
        for (int i = 0; i < depths.length && !(noise == 0 && errors.isNone()); i++) {
            if (depths[i] < Float.POSITIVE_INFINITY) {
                double off = noise == 0 ? 0 : noise * depths[i] * depths[i] * random.normal(step, DEPTH, i);
                double depth = errors.applyAt(depths[i] + off, step, drifts[0], i);
                boolean lost = errors.drops(step, i) || depth < camera.getNear() || depth > camera.getFar();
                depths[i] = lost ? Float.POSITIVE_INFINITY : (float) depth;
            }
        }
    }

    /** A dropped-out pixel is NaN. */
    private void measureHeat(float[] temperatures, long step) {
        double noise = camera.getNetd();
        for (int i = 0; i < temperatures.length && !(noise == 0 && errors.isNone()); i++) {
            double off = noise == 0 ? 0 : noise * random.normal(step, HEAT, i);
            temperatures[i] = errors.drops(step, i) ? Float.NaN
                : (float) errors.applyAt(temperatures[i] + off, step, drifts[0], i);
        }
    }

    /** A dropped-out pixel is black. */
    private void measureColors(int[] pixels, long step) {
        for (int i = 0; i < pixels.length && !errors.isNone(); i++) {
            pixels[i] = errors.drops(step, i) ? 0 : level(pixels[i] >> 16, step, i, 0) << 16
                | level(pixels[i] >> 8, step, i, 1) << 8 | level(pixels[i], step, i, 2);
        }
    }

    private int level(int shifted, long step, int pixel, int channel) {
        double level = errors.applyAt(shifted & 0xff, step, drifts[channel], CHANNELS * pixel + channel);
        return (int) Math.round(Math.max(0, Math.min(FULL, level)));
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Camera.class;
        }

        @Override
        public String description() {
            return "pictures, row by row from the top left: colours as 0xRRGGBB, depths along the axis in m, or "
                + "temperatures in degC";
        }

        @Override
        public String unit() {
            return "of 255, m or degC";
        }

        @Override
        public String unit(SearObject parameters) {
            switch (((Camera) parameters).getKind()) {
                case Camera.DEPTH:
                    return "m";
                case Camera.INFRARED:
                    return "degC";
                default:
                    return "of 255";
            }
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new CameraSensor((Camera) parameters, seed);
        }
    }
}
