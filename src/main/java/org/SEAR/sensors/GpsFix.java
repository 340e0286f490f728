package org.SEAR.sensors;

/** Where a GPS sensor is and how it moves, on WGS84. Immutable, any thread. */
public final class GpsFix implements Reading {
    /** A centimetre on Earth. */
    private static final int PLACE_DIGITS = 7;

    private final double latitude;
    private final double longitude;
    private final double altitude;
    private final double speed;
    private final double course;
    private final double climb;
    private final long time;
    private final boolean valid;

    /** A valid fix of something that moves on the level. */
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
     * @param course over ground, degrees clockwise from true north, [0, 360); 0 while standing
     * @param climb upwards, m/s
     * @param time UTC of the fix, milliseconds since 1970
     */
    public GpsFix(double latitude, double longitude, double altitude, double speed, double course, double climb, long time) {
        this(latitude, longitude, altitude, speed, course, climb, time, true);
    }

    private GpsFix(double latitude, double longitude, double altitude, double speed, double course, double climb, long time, boolean valid) {
        this.latitude = latitude;
        this.longitude = longitude;
        this.altitude = altitude;
        this.speed = speed;
        this.course = course;
        this.climb = climb;
        this.time = time;
        this.valid = valid;
    }

    /** The receiver lost its satellites: it knows the time only, all else is NaN. */
    public static GpsFix none(long time) {
        return new GpsFix(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, time, false);
    }

    /** Whether there is a position. */
    public boolean isValid() {
        return valid;
    }

    /** Degrees, + north. */
    public double getLatitude() {
        return latitude;
    }

    /** Degrees, + east. */
    public double getLongitude() {
        return longitude;
    }

    /** Metres above mean sea level. */
    public double getAltitude() {
        return altitude;
    }

    /** Speed over ground, m/s. */
    public double getSpeed() {
        return speed;
    }

    /** Course over ground, degrees clockwise from true north, [0, 360). */
    public double getCourse() {
        return course;
    }

    /** Speed upwards, m/s. */
    public double getClimb() {
        return climb;
    }

    /** UTC of the fix, milliseconds since 1970. */
    public long getTime() {
        return time;
    }

    /** Latitude, longitude, altitude. */
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
