// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Included;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;

/**
 * Position of the robot on Earth; with ports also a receiver that sends NMEA 0183 sentences. Latitude, altitude and
 * longitude are those of the world's origin: degrees, metres, degrees, north and east positive. In a world with a
 * {@link Terrain} the default is that of its map.
 */
@Described("position of the robot on Earth; with ports also a receiver that sends NMEA 0183")
public class GPS extends SensorObject implements SerialObject {
    private static final int MEDIATEK_BAUD = 38400;
    private static final int UBLOX_BAUD = 9600;

    @Param(doc = "latitude of the world's origin, north positive; without latitude, altitude and longitude the terrain "
        + "defines it", unit = "deg", min = -90, max = 90, initial = "0")
    private Double latitude;
    @Param(doc = "altitude of the world's origin", unit = "m", min = -12000, max = 100000, initial = "0")
    private Double altitude;
    @Param(doc = "longitude of the world's origin, east positive", unit = "deg", min = -180, max = 180, initial = "0")
    private Double longitude;
    @Included
    private final SerialParameters serial = new SerialParameters(this, MEDIATEK_BAUD);
    @Param(doc = "receiver at the ports", text = TextRule.GPS_MODEL)
    private String model = "MT3301";
    @Param(doc = "fixes a second", unit = "Hz", min = 0.1, max = 5)
    private double rate = 1;
    @Param(doc = "simulated time without a fix after power-on or a cold start", unit = "s", max = 1e6)
    private double timeToFix;
    @Param(doc = "time between a fix and the start of its output", unit = "s", max = 1)
    private double latency;

    /** For reading from a file. */
    protected GPS() {
    }

    /** With the terrain's map as reference. */
    public GPS(String name) {
        super(name);
        created(GPS.class);
    }

    /**
     * With ports, and the terrain's map as reference.
     *
     * @param uart the device's end
     * @param user the end that the user opens
     */
    public GPS(String name, String uart, String user) {
        super(name);
        setPorts(uart, user);
        created(GPS.class);
    }

    /**
     * @param latitude degrees
     * @param altitude metres
     * @param longitude degrees
     */
    public GPS(String name, double latitude, double altitude, double longitude) {
        this(name, latitude, altitude, longitude, 0, 0, 0);
    }

    /**
     * With ports.
     *
     * @param uart the device's end
     * @param user the end that the user opens
     */
    public GPS(String name, double latitude, double altitude, double longitude, String uart, String user) {
        super(name);
        this.latitude = latitude + 0.0;
        this.altitude = altitude + 0.0;
        this.longitude = longitude + 0.0;
        setPorts(uart, user);
        created(GPS.class);
    }

    /** With its antenna at (x, y, z) of the body frame, metres. */
    public GPS(String name, double latitude, double altitude, double longitude, double x, double y, double z) {
        super(name);
        this.latitude = latitude + 0.0;
        this.altitude = altitude + 0.0;
        this.longitude = longitude + 0.0;
        pose(x, y, z, 0, 0, 0);
        created(GPS.class);
    }

    @Override
    protected void crossCheck(Faults faults) {
        if ((latitude == null || altitude == null || longitude == null) && hasAny()) {
            faults.add(latitude != null ? "latitude" : altitude != null ? "altitude" : "longitude",
                latitude != null ? latitude : altitude != null ? altitude : longitude,
                "all of latitude, altitude and longitude, or none to use the terrain's");
        }
    }

    private boolean hasAny() {
        return latitude != null || altitude != null || longitude != null;
    }

    /** Returns whether the sensor has its own geographic reference of the world's origin, instead of the terrain's. */
    public boolean hasReference() {
        return latitude != null && altitude != null && longitude != null;
    }

    public Double getLatitude() {
        return latitude;
    }

    public Double getAltitude() {
        return altitude;
    }

    public Double getLongitude() {
        return longitude;
    }

    @Override
    public SerialParameters getSerial() {
        return serial;
    }

    public String getModel() {
        return model;
    }

    public double getRate() {
        return rate;
    }

    /**
     * Sets the receiver. A baud rate that is the present receiver's default changes to the new receiver's default:
     * 38400 for MT3301 and MT3329, 9600 for NEO-M8N.
     *
     * @param newModel MT3301 (also FV-M8, FV-M11), MT3329 or NEO-M8N (also u-blox)
     */
    public void setModel(String newModel) {
        int old = deliveredBaud(model);
        model = checked("model", newModel);
        if (getBaud() == old && old != deliveredBaud(newModel)) {
            setBaud(deliveredBaud(newModel));
        }
        changed();
    }

    private static int deliveredBaud(String receiver) {
        return TextRule.isUblox(receiver) ? UBLOX_BAUD : MEDIATEK_BAUD;
    }

    /** @param hertz fixes a second, 0.1 to 5 */
    public void setRate(double hertz) {
        rate = checked("rate", hertz);
        changed();
    }

    public double getTimeToFix() {
        return timeToFix;
    }

    public void setTimeToFix(double seconds) {
        timeToFix = checked("timeToFix", seconds);
        changed();
    }

    public double getLatency() {
        return latency;
    }

    /**
     * Sets the time that the receiver computes before it sends a fix; the fix keeps its own time and place.
     *
     * @param seconds 0 to 1; real receivers take some 0.05 to 0.2
     */
    public void setLatency(double seconds) {
        latency = checked("latency", seconds);
        changed();
    }
}
