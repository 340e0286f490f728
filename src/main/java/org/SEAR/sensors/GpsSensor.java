// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.Pose;

/**
 * Position and motion of the antenna on WGS84.
 *
 * <p>Latitude and longitude are the end of the geodesic to (x north, z east) of the world ({@link GeoOrigin}). It
 * starts at the object's reference point, otherwise at the terrain's. Altitude = reference altitude + y. Speed is the
 * antenna's speed over ground; course counts from true north at the robot. Time is simulated. Errors are metres in the
 * world: north, up and east.
 */
public final class GpsSensor extends Sensor<GpsFix> {
    /** Speed below which the antenna is at rest and has no course, m/s. */
    private static final double STANDING = 0.005;
    private static final int NORTH = 0;
    private static final int UP = 1;
    private static final int EAST = 2;

    /** Distance from the terrain's reference above which a reference is another place, metres. */
    private static final double SAME_PLACE = 1;

    /** The sensor's own reference; null if it uses the terrain's. */
    private final GeoOrigin origin;

    /** @param seed random seed of the simulation */
    public GpsSensor(GPS parameters, long seed) {
        super(parameters, seed, 3);
        this.origin = parameters.hasReference()
            ? new GeoOrigin(parameters.getLatitude(), parameters.getAltitude(), parameters.getLongitude()) : null;
    }

    @Override
    protected GpsFix measure(Truth truth) {
        long step = truth.step();
        long time = truth.epochMillis() + Math.round(truth.time() * 1000);
        if (errors.drops(step, 0)) {
            return GpsFix.none(time);
        }
        Pose pose = pose(truth);
        GeoOrigin from = origin == null ? truth.earth().getOrigin() : origin;
        GeoOrigin.GeoPoint place = from.at(errors.apply(pose.x, step, NORTH, NORTH), errors.apply(pose.y, step, UP, UP),
            errors.apply(pose.z, step, EAST, EAST));
        double[] arm = truth.body().rotate(getMount().x, getMount().y, getMount().z);
        double[] turn = truth.angularVelocity();
        double north = truth.velocity()[0] + turn[1] * arm[2] - turn[2] * arm[1];
        double east = truth.velocity()[2] + turn[0] * arm[1] - turn[1] * arm[0];
        double climb = truth.velocity()[1] + turn[2] * arm[0] - turn[0] * arm[2];
        double speed = Math.hypot(north, east);
        double course = speed < STANDING ? 0 : course(Math.toDegrees(Math.atan2(east, north)) + place.convergence);
        return new GpsFix(place.latitude, place.longitude, place.altitude, speed, course, climb, time);
    }

    /**
     * Returns where a fix of this sensor is in the world: metres north, up and east of the world's origin; NaN without
     * a position.
     */
    public double[] metres(GpsFix fix, Truth truth) {
        if (!fix.isValid()) {
            return new double[] {Double.NaN, Double.NaN, Double.NaN};
        }
        GeoOrigin from = origin == null ? truth.earth().getOrigin() : origin;
        double[] place = from.to(fix.getLatitude(), fix.getLongitude());
        return new double[] {place[0], fix.getAltitude() - from.getAltitude(), place[1]};
    }

    /** Returns the same angle in [0, 360). */
    private static double course(double degrees) {
        double turned = degrees - 360 * Math.floor(degrees / 360);
        return turned >= 360 ? 0 : turned;
    }

    @Override
    public List<String> warnings(Truth truth) {
        GeoOrigin ground = truth.earth().isOfTerrain() ? truth.earth().getOrigin() : null;
        if (origin == null || ground == null
            || Math.hypot(Math.hypot(ground.to(origin.getLatitude(), origin.getLongitude())[0],
                ground.to(origin.getLatitude(), origin.getLongitude())[1]), ground.getAltitude() - origin.getAltitude())
                    < SAME_PLACE) {
            return Collections.emptyList();
        }
        return Collections.singletonList("gps " + getName() + " puts the world's origin at " + origin
            + ", but the terrain puts it at " + ground
            + "; the GPS uses its own; GPS(name) without coordinates uses the terrain's");
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return GPS.class;
        }

        @Override
        public String description() {
            return "position on WGS84: latitude and longitude in degrees, altitude in m, speed in m/s, course in "
                + "degrees, UTC";
        }

        @Override
        public String unit() {
            return "deg, deg, m";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new GpsSensor((GPS) parameters, seed);
        }
    }
}
