// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.Pose;

/**
 * Heading of the sensor's forward axis, degrees clockwise from north, (-180, 180]; NaN after a drop-out.
 *
 * <p>True heading = angle, seen from above, from the direction to the object's north point to the forward axis. The
 * default north point is 100 km along +x. Magnetic heading = true heading - declination, east positive. The declination
 * comes from the {@link Earth}'s magnetic model at the robot's position, height and simulated date. Only the horizontal
 * part of the axis counts; straight up or down the heading is 0. No error unless the object has noise.
 */
public final class CompassSensor extends Sensor<Quantity> {
    private static final double METRES_PER_KILOMETRE = 1000;
    private static final double AT_THE_POLE = 1e-6;

    private final Compass compass;

    /** @param seed random seed of the simulation */
    public CompassSensor(Compass parameters, long seed) {
        super(parameters, seed, 1);
        this.compass = parameters;
    }

    @Override
    protected Quantity measure(Truth truth) {
        if (errors.drops(truth.step(), 0)) {
            return new Quantity(Double.NaN, 1);
        }
        Pose pose = pose(truth);
        double[] forward = pose.rotate(0, 0, 1);
        double heading = angle(forward[0], forward[2]) - north(pose);
        if (compass.isDeclination() && truth.earth().getOrigin() != null) {
            heading -= declination(truth, pose);
        }
        return new Quantity(wrap(errors.apply(wrap(heading), truth.step(), 0, 0)), 1);
    }

    /** Returns degrees clockwise from +x, seen from above. */
    private static double angle(double x, double z) {
        return Math.toDegrees(Math.atan2(z, x));
    }

    private double north(Pose pose) {
        double x = compass.getNorthX() - pose.x;
        double z = compass.getNorthZ() - pose.z;
        return Math.hypot(x, z) < AT_THE_POLE ? angle(compass.getNorthX(), compass.getNorthZ()) : angle(x, z);
    }

    private static double declination(Truth truth, Pose pose) {
        return field(truth, pose).declination();
    }

    /**
     * Returns the Earth's magnetic field at a position and the simulated date, in a world with a known origin on Earth.
     */
    static MagneticModel.Field field(Truth truth, Pose pose) {
        GeoOrigin.GeoPoint place = truth.earth().getOrigin().at(pose.x, pose.y, pose.z);
        return truth.earth().getMagneticModel()
            .field(place.latitude, place.longitude, place.altitude / METRES_PER_KILOMETRE, decimalYear(truth));
    }

    /** Returns the simulated date as a year with fraction. */
    private static double decimalYear(Truth truth) {
        long millis = truth.epochMillis() + Math.round(truth.time() * 1000);
        LocalDateTime date = LocalDateTime.ofInstant(Instant.ofEpochMilli(millis), ZoneOffset.UTC);
        double day = date.getDayOfYear() - 1 + date.toLocalTime().toNanoOfDay() / 86400e9;
        return date.getYear() + day / date.toLocalDate().lengthOfYear();
    }

    /** Returns the same angle in (-180, 180]. */
    static double wrap(double degrees) {
        double turned = Math.IEEEremainder(degrees, 360);
        return turned <= -180 ? turned + 360 : turned + 0.0;
    }

    @Override
    public List<String> warnings(Truth truth) {
        if (!compass.isDeclination()) {
            return Collections.emptyList();
        }
        if (truth.earth().getOrigin() == null) {
            return Collections.singletonList("compass " + getName() + " shows true north: without a GPS the world's "
                + "place on Earth is unknown; add a GPS for the declination");
        }
        MagneticModel model = truth.earth().getMagneticModel();
        double year = decimalYear(truth);
        if (model.covers(year)) {
            return Collections.emptyList();
        }
        return Collections.singletonList(
            String.format(java.util.Locale.ROOT, "compass %s: %s is valid from %.1f to %.1f, the simulated "
                + "date is %.1f;"
            + " the declination is less accurate; put that year's coefficients into assets/%s", getName(),
            model.getName(), model.getEpoch(), model.getEpoch() + MagneticModel.YEARS_VALID, year, Earth.MODEL_FILE));
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Compass.class;
        }

        @Override
        public String description() {
            return "heading of the sensor's forward axis, clockwise from north: degrees, above -180 to 180";
        }

        @Override
        public String unit() {
            return "deg";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new CompassSensor((Compass) parameters, seed);
        }
    }
}
