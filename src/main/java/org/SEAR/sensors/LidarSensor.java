// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.List;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;

/**
 * A plane of beams: range i = distance from the sensor's origin to the nearest surface in the direction (sin a, 0, cos
 * a) of its frame, a = i * resolution - spread / 2, + left; +infinity beyond the range. All beams of a scan have the
 * same instant unless the object has a scan time; devices measure {@link #range each beam at its time}. Parts of the
 * sensor's own robot are invisible unless the object says otherwise. Each beam has its own white error and drop-out,
 * which is a missing return. All beams share bias and drift.
 */
public final class LidarSensor extends Sensor<LidarScan> implements LidarSource {
    /** Fraction of a step by which a spread may miss a whole number of steps. */
    private static final double ROUNDING = 1e-9;
    private static final double CIRCLE = 360;

    private final LIDAR lidar;
    /** Time and parameters of the expected scan. */
    private double expectedAt = Double.POSITIVE_INFINITY;
    private double expectedSpread;
    private double expectedResolution;
    /** The scan measured before its request, and the sensor's mount at that time; null if there is none. */
    private LidarScan ahead;
    private Pose aheadMount;
    private final PoseHistory history = new PoseHistory();

    /** @param seed random seed of the simulation */
    public LidarSensor(LIDAR parameters, long seed) {
        super(parameters, seed, 1);
        this.lidar = parameters;
    }

    @Override
    public List<String> warnings(Truth truth) {
        GroundCheck check = new GroundCheck(truth, ignored(truth), pose(truth));
        for (int i = 0; i < beamsAside(); i++) {
            double angle = Math.toRadians(i * lidar.getResolution() - lidar.getSpread() / 2);
            check.look(Math.sin(angle), 0, Math.cos(angle), lidar.getRange());
        }
        return check.warnings(getName());
    }

    @Override
    protected LidarScan measure(Truth truth) {
        LidarScan scan = make(truth, lidar.getSpread(), lidar.getResolution(), lidar.getBeams());
        return lidar.getScanTime() > 0 ? roll(truth, scan) : scan;
    }

    /** Measures one beam after the other, the leftmost now. */
    private LidarScan roll(Truth truth, LidarScan scan) {
        double perBeam = lidar.getScanTime() * scan.getResolution() / CIRCLE;
        double[] ranges = new double[scan.size()];
        for (int beam = 0; beam < ranges.length; beam++) {
            ranges[beam] = range(truth, scan, beam, truth.time() - (ranges.length - 1 - beam) * perBeam);
        }
        return new LidarScan(scan.getSpread(), scan.getResolution(), scan.getMaxRange(), ranges, scan.step());
    }

    @Override
    public double range(Truth truth, LidarScan scan, int beam, double time) {
        double at = time / truth.stepLength();
        BeamScene scene = truth.scene();
        boolean rests = history.isAtRest(at, scan.step(), truth.step());
        if (rests && (history.isEmpty() || !scene.hasMoved(Math.min(at, scan.step()), at))) {
            return scan.range(beam);
        }
        history.find(at);
        double angle = Math.toRadians(scan.angle(beam));
        history.aim(Math.sin(angle), Math.cos(angle));
        if (rests && !scene.isNearMoving(at, scan.step(), history.x, history.y, history.z, history.dx, history.dy,
            history.dz, lidar.getRange(), ignored(truth))) {
            return scan.range(beam);
        }
        double range = scene.castAt(at, history.x, history.y, history.z, history.dx, history.dy, history.dz,
            lidar.getRange(), ignored(truth));
        return errors.isNone() ? range : disturbed(range, scan.step(), beam);
    }

    private int ignored(Truth truth) {
        return lidar.isSeesOwnRobot() ? BeamScene.WORLD : truth.owner();
    }

    @Override
    public void track(Truth truth) {
        super.track(truth);
        history.add(truth.step(), truth.body(), getMount());
        if (lidar.isRolling()) {
            truth.scene().remember(truth.step());
        }
    }

    @Override
    public void moved() {
        history.clear(false);
    }

    @Override
    public int beamsAside() {
        return lidar.getBeams();
    }

    @Override
    public void reset() {
        super.reset();
        expectedAt = Double.POSITIVE_INFINITY;
        ahead = null;
        history.clear(true);
    }

    @Override
    public void expect(double time, double spreadDegrees, double resolutionDegrees) {
        expectedAt = time;
        expectedSpread = spreadDegrees;
        expectedResolution = resolutionDegrees;
    }

    /** Returns the beams of the scan expected by a time; 0 if none is expected. */
    int beamsExpected(double end) {
        return expectedAt <= end ? beams(expectedSpread, expectedResolution) : 0;
    }

    /** Measures the expected scan. Any thread, like {@link #measure}. */
    void scanAhead(Truth truth) {
        expectedAt = Double.POSITIVE_INFINITY;
        ahead = make(truth, expectedSpread, expectedResolution, beams(expectedSpread, expectedResolution));
        aheadMount = getMount();
    }

    /** Drops the scan measured ahead, because the world may have changed. */
    public void forgetAhead() {
        ahead = null;
    }

    private static int beams(double spreadDegrees, double resolutionDegrees) {
        return (int) Math.floor(spreadDegrees / resolutionDegrees + ROUNDING) + 1;
    }

    @Override
    public LidarScan scan(Truth truth, double spreadDegrees, double resolutionDegrees) {
        expectedAt = Double.POSITIVE_INFINITY;
        boolean isAhead = ahead != null && aheadMount == getMount() && ahead.getSpread() == spreadDegrees
            && ahead.getResolution() == resolutionDegrees;
        return isAhead ? ahead : make(truth, spreadDegrees, resolutionDegrees, beams(spreadDegrees, resolutionDegrees));
    }

    private LidarScan make(Truth truth, double spreadDegrees, double resolutionDegrees, int beams) {
        if (!(spreadDegrees > 0 && spreadDegrees <= 360 && resolutionDegrees > 0
            && resolutionDegrees <= spreadDegrees)) {
            throw new IllegalArgumentException("LIDAR " + getName() + ": spread " + spreadDegrees + " and resolution "
                + resolutionDegrees + " degrees, legal: spread above 0 to 360, resolution above 0 to the spread");
        }
        double[] ranges = new double[beams];
        Pose pose = pose(truth);
        truth.scene().castFan(pose, Math.toRadians(-spreadDegrees / 2), Math.toRadians(resolutionDegrees),
            ranges.length, lidar.getRange(), ignored(truth), ranges, null);
        if (!errors.isNone()) {
            for (int beam = 0; beam < ranges.length; beam++) {
                ranges[beam] = disturbed(ranges[beam], truth.step(), beam);
            }
        }
        return new LidarScan(spreadDegrees, resolutionDegrees, lidar.getRange(), ranges, truth.step());
    }

    private double disturbed(double range, long step, int beam) {
        if (errors.drops(step, beam)) {
            return Double.POSITIVE_INFINITY;
        }
        return range == Double.POSITIVE_INFINITY ? range
            : Math.max(0, Math.min(lidar.getRange(), errors.apply(range, step, 0, beam)));
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return LIDAR.class;
        }

        @Override
        public String description() {
            return "distances in a plane of beams, right to left: m (scripts get the maximum range without a hit)";
        }

        @Override
        public String unit() {
            return "m";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new LidarSensor((LIDAR) parameters, seed);
        }
    }
}
