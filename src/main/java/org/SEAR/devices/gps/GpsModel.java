package org.SEAR.devices.gps;

/** What distinguishes receivers: data. Source: recordings of real ones. */
public enum GpsModel {
    /** San Jose Navigation FV-M8, FV-M11. */
    MT3301(6, 3, 200, "8960.000000,N,00000.000000,E", "137.000,M,13.000,M", "MTK3301_1.0", "PMTK010,001"),
    /** GlobalTop and others. */
    MT3329(4, 1, 100, ",,,", ",M,,M", "AXN_1.30", "PMTK010,001");

    private final int minuteDecimals;
    private final int altitudeDecimals;
    private final int shortestPeriod;
    private final String noPosition;
    private final String noAltitude;
    private final String release;
    private final String greeting;

    GpsModel(int minuteDecimals, int altitudeDecimals, int shortestPeriod, String noPosition, String noAltitude, String release, String greeting) {
        this.minuteDecimals = minuteDecimals;
        this.altitudeDecimals = altitudeDecimals;
        this.shortestPeriod = shortestPeriod;
        this.noPosition = noPosition;
        this.noAltitude = noAltitude;
        this.release = release;
        this.greeting = greeting;
    }

    /**
     * The model of that name; FV-M8 and FV-M11 are MT3301.
     *
     * @throws IllegalArgumentException that names the models there are
     */
    public static GpsModel of(String name) {
        String plain = name.replaceAll("[^A-Za-z0-9]", "");
        if (plain.equalsIgnoreCase("FVM8") || plain.equalsIgnoreCase("FVM11")) {
            return MT3301;
        }
        for (GpsModel model : values()) {
            if (model.name().equalsIgnoreCase(plain)) {
                return model;
            }
        }
        throw new IllegalArgumentException("GPS model " + name + ": there are MT3301 (also FV-M8, FV-M11) and MT3329");
    }

    int getMinuteDecimals() {
        return minuteDecimals;
    }

    int getAltitudeDecimals() {
        return altitudeDecimals;
    }

    /** Milliseconds from fix to fix at the highest rate. */
    public int getShortestPeriod() {
        return shortestPeriod;
    }

    /** Fields 2 to 5 of GGA without a fix. */
    String getNoPosition() {
        return noPosition;
    }

    /** Fields 9 to 12 of GGA without a fix. */
    String getNoAltitude() {
        return noAltitude;
    }

    /** Answer to PMTK605. */
    String getRelease() {
        return release;
    }

    /** First sentence after power-on. */
    String getGreeting() {
        return greeting;
    }
}
