// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/** Position and motion of a GPS sensor on WGS84. Immutable; any thread. */
public final class GpsFix implements Reading {
    /** Decimals of a degree; 7 are a centimetre on the Earth. */
    private static final int PLACE_DIGITS = 7;

    private final double latitude;
    private final double longitude;
    private final double altitude;
    private final double speed;
    private final double course;
    private final double climb;
    private final long time;
    private final boolean valid;

    /** A valid fix with level motion. */
    public GpsFix(double latitude, double longitude, double altitude, double speed, double course, long time) {
        this(latitude, longitude, altitude, speed, course, 0, time);
    }

    /**
     * A valid fix.
     *
     * @param latitude degrees, + north
     * @param longitude degrees, + east, [-180, 180)
     * @param altitude metres above mean sea level
     * @param speed over ground, m/s, never negative
     * @param course over ground, degrees clockwise from true north, [0, 360); 0 at rest
     * @param climb upwards, m/s
     * @param time UTC of the fix, milliseconds since 1970
     */
    public GpsFix(double latitude, double longitude, double altitude, double speed, double course, double climb,
        long time) {
        this(latitude, longitude, altitude, speed, course, climb, time, true);
    }

    private GpsFix(double latitude, double longitude, double altitude, double speed, double course, double climb,
        long time, boolean valid) {
        this.latitude = latitude;
        this.longitude = longitude;
        this.altitude = altitude;
        this.speed = speed;
        this.course = course;
        this.climb = climb;
        this.time = time;
        this.valid = valid;
    }

    /** Returns a fix without satellites: only the time is known, all else is NaN. */
    public static GpsFix none(long time) {
        return new GpsFix(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, time, false);
    }

    /** Returns whether there is a position. */
    public boolean isValid() {
        return valid;
    }

    /** Returns degrees, + north. */
    public double getLatitude() {
        return latitude;
    }

    /** Returns degrees, + east. */
    public double getLongitude() {
        return longitude;
    }

    /** Returns metres above mean sea level. */
    public double getAltitude() {
        return altitude;
    }

    /** Returns the speed over ground, m/s. */
    public double getSpeed() {
        return speed;
    }

    /** Returns the course over ground, degrees clockwise from true north, [0, 360). */
    public double getCourse() {
        return course;
    }

    /** Returns the speed upwards, m/s. */
    public double getClimb() {
        return climb;
    }

    /** Returns the UTC of the fix, milliseconds since 1970. */
    public long getTime() {
        return time;
    }

    /** Returns latitude, longitude, altitude. */
    @Override
    public double[] numbers() {
        return new double[] {latitude, longitude, altitude};
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.fixed(kept[0], PLACE_DIGITS) + ", " + ReadingWords.fixed(kept[1], PLACE_DIGITS) + " deg, "
            + ReadingWords.fixed(kept[2], 2) + " m";
    }

    @Override
    public String toString() {
        return latitude + ", " + longitude + ", " + altitude + " m";
    }
}
