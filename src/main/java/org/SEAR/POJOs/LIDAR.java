// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Included;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.lidar.LidarModel;

/** A fan of beams in one plane; with ports and LMS(1) also a device of its model. */
@Described("a fan of beams in one plane; with ports also a SICK LMS200 or another model")
public class LIDAR extends SensorObject implements SerialObject {
    private static final int MAX_BEAMS = 36001;
    private static final double CIRCLE = 360;
    /** Fraction of a step by which a spread may miss a whole number of steps. */
    private static final double ROUNDING = 1e-9;

    @Param(doc = "largest distance", unit = "m", min = 0.01, max = 10000)
    private double range = 8.191;
    @Param(doc = "angle from the rightmost to the leftmost beam", unit = "deg", min = 0.01, max = 360)
    private double spread = 180;
    @Param(doc = "angle between two beams", unit = "deg", min = 0.01, max = 360)
    private double resolution = 1;
    @Param(doc = "whether a reading of 360 degrees ends with a beam in the direction of its first one; default: true")
    private Boolean closed;
    @Param(doc = "duration of a turn in which a reading's beams are measured one after another, 0: all at one instant; "
        + "a device at ports has its own",
        unit = "s", max = 1)
    private double scanTime;
    @Included
    private final SerialParameters serial = new SerialParameters(this, 9600);
    @Param(doc = "device at the ports", text = TextRule.LIDAR_MODEL)
    private String model = LidarModel.LMS200.getName();
    @Param(doc = "1 for a device at the ports, 0 for none", values = {"0", "1"}, max = 1)
    private int lms = 1;
    @Param(doc = "whether an LMS2xx accepts the baud telegrams with a wrong checksum from MyRobotLab's old driver")
    private boolean lenient;
    @Param(doc = "whether its beams hit parts of its own robot")
    private boolean seesOwnRobot;

    /** For reading from a file. */
    protected LIDAR() {
    }

    /** 8.191 m, 180 degrees, 1 degree. */
    public LIDAR(String name) {
        super(name);
        created(LIDAR.class);
    }

    /**
     * @param range m
     * @param spread degrees
     * @param resolution degrees
     */
    public LIDAR(String name, double range, double spread, double resolution) {
        this(name, range, spread, resolution, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres. */
    public LIDAR(String name, double range, double spread, double resolution, double x, double y, double z) {
        this(name, range, spread, resolution, x, y, z, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    public LIDAR(String name, double range, double spread, double resolution, double x, double y, double z, double rx,
        double ry, double rz) {
        super(name);
        this.range = range;
        this.spread = spread;
        this.resolution = resolution;
        pose(x, y, z, rx, ry, rz);
        created(LIDAR.class);
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (resolution > spread) {
            faults.add("resolution", resolution, "at most the spread, " + Parameter.format(spread) + " deg");
        } else if (spread / resolution > MAX_BEAMS - 1) {
            faults.add("resolution", resolution, "at most " + MAX_BEAMS + " beams: at least "
                + Parameter.format(spread / (MAX_BEAMS - 1)) + " deg");
        }
    }

    public double getRange() {
        return range;
    }

    public double getSpread() {
        return spread;
    }

    public double getResolution() {
        return resolution;
    }

    /** Returns whether a reading of 360 degrees ends with a beam in the direction of its first one. */
    public boolean isClosed() {
        return closed == null || closed;
    }

    /** Returns the number of beams of a reading. */
    public int getBeams() {
        int steps = (int) Math.floor(spread / resolution + ROUNDING);
        boolean repeats = spread == CIRCLE && steps * resolution > CIRCLE * (1 - ROUNDING);
        return repeats && !isClosed() ? steps : steps + 1;
    }

    public double getScanTime() {
        return scanTime;
    }

    /** Returns whether its beams, or those of the device at its ports, are measured one after another. */
    public boolean isRolling() {
        return scanTime > 0 || hasDevice();
    }

    @Override
    public SerialParameters getSerial() {
        return serial;
    }

    public int getLms() {
        return lms;
    }

    public boolean isSeesOwnRobot() {
        return seesOwnRobot;
    }

    public String getModel() {
        return model;
    }

    /**
     * Sets the model, and with it the model's default range, spread, resolution and baud rate.
     *
     * @param name LMS200, LMS221, LMS291, LMS111, TiM561, URG-04LX, UTM-30LX, RPLIDAR-A1 or CoLa (any fan); case and
     *     punctuation are ignored
     * @throws IllegalArgumentException with the names of the models
     */
    public void setModel(String name) {
        LidarModel wanted = LidarModel.of(checked("model", name));
        model = wanted.getName();
        range = wanted.getRange();
        spread = wanted.getSpread();
        resolution = wanted.getResolution();
        setBaud(wanted.getBaud());
    }

    /**
     * Connects the device of the {@link #setModel model} to a pair of ports, unless {@link #LMS} has switched it off. A
     * device supports only some fans.
     *
     * @param uart the device's end
     * @param user the end that the user opens
     * @throws IllegalArgumentException if the model doesn't support the fan; without ports every fan is legal
     */
    @Override
    public void setPorts(String uart, String user) {
        if (uart != null) {
            checkFan(lms);
        }
        SerialObject.super.setPorts(uart, user);
    }

    private LidarModel device() {
        return LidarModel.of(model);
    }

    private void checkFan(int type) {
        if (type == 1 && !device().hasFan(spread, resolution)) {
            throw new IllegalArgumentException(noSuchFan());
        }
    }

    private String noSuchFan() {
        String able = LidarModel.namesWith(spread, resolution);
        return atItsPort() + ", and none has spread " + Parameter.format(spread) + " with resolution "
            + Parameter.format(resolution)
            + " deg, legal: " + device().fans() + "; without setPorts every fan, read with sear.getLidarResult(\""
            + getName() + "\")" + (able.isEmpty() ? "; no model has it" : "; setModel has it with " + able);
    }

    private String atItsPort() {
        return label() + ": at a port there is " + device().withArticle();
    }

    private boolean hasDevice() {
        return getUartPort() != null && lms == 1;
    }

    /**
     * Writes a changed fan. An unsupported one gives a warning, not an error: the script may go on to change the other
     * angle.
     */
    private void fanChanged() {
        changed();
        if (hasDevice() && !device().hasFan(spread, resolution)) {
            Notices.say(noSuchFan() + "; until then the device starts with " + device().widestFan());
        }
    }

    /**
     * Sets the range, and warns if the device at the port can't report such a distance.
     *
     * @param metres 0.01 to 10000
     */
    public void setRange(double metres) {
        range = checked("range", metres);
        changed();
        if (hasDevice() && range > device().getFarthest()) {
            Notices.say(atItsPort() + ", which reports at most " + Parameter.format(device().getFarthest())
                + " m, but the range is "
                + Parameter.format(range) + " m: read greater distances with sear.getLidarResult(\""
                    + getName() + "\")");
        }
    }

    /**
     * Sets the spread, and warns if the device at the port doesn't support it.
     *
     * @param degrees from the rightmost to the leftmost beam, 0.01 to 360
     */
    public void setSpread(double degrees) {
        spread = checked("spread", degrees);
        fanChanged();
    }

    /**
     * Sets the resolution, and warns if the device at the port doesn't support it.
     *
     * @param degrees between two beams, 0.01 to 360
     */
    public void setResolution(double degrees) {
        resolution = checked("resolution", degrees);
        fanChanged();
    }

    /**
     * Sets whether a reading of 360 degrees ends with a beam in the direction of its first one. ROS wants none. The
     * device at ports sends the beams of its model instead.
     *
     * @param on true, the default: 361 beams at 1 degree; false: 360, the last one at 179 degrees
     */
    public void setClosed(boolean on) {
        closed = checked("closed", on);
        changed();
    }

    /**
     * Lets the beams of a reading be measured one after another, from right to left, as by a rotating mirror. The
     * leftmost is of the time of the reading, each other one earlier by the time in which the mirror turns between
     * them. The device at ports measures at its model's speed instead.
     *
     * @param seconds duration of a turn of 360 degrees, 0 to 1; 0, the default: all beams at one instant
     */
    public void setScanTime(double seconds) {
        scanTime = checked("scanTime", seconds);
        changed();
    }

    /** @param newLms 1 for a device of its {@link #setModel model} at the ports, 0 for none */
    public void LMS(int newLms) {
        int wanted = checked("lms", newLms);
        if (getUartPort() != null) {
            checkFan(wanted);
        }
        lms = wanted;
        changed();
    }

    public void setSeesOwnRobot(boolean on) {
        seesOwnRobot = checked("seesOwnRobot", on);
        changed();
    }

    /**
     * Returns whether an LMS2xx accepts the baud telegrams with a wrong checksum that MyRobotLab's old driver sends; a
     * real LMS2xx answers NAK.
     */
    public boolean isLenient() {
        return lenient;
    }

    public void setLenient(boolean obey) {
        lenient = checked("lenient", obey);
        changed();
    }
}
