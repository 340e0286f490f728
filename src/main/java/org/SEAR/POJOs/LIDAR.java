package org.SEAR.POJOs;

import org.SEAR.protocol.lms.Variant;

/** A plane of beams; behind its ports a SICK LMS200 if LMS(1). */
@Described("a plane of beams; behind its ports a SICK LMS200")
public class LIDAR extends SensorObject implements SerialObject {
    private static final int MAX_BEAMS = 36001;

    @Param(doc = "farthest distance", unit = "m", min = 0.01, max = 10000)
    private double range = 8.191;
    @Param(doc = "angle from the rightmost to the leftmost beam", unit = "deg", min = 0.01, max = 360)
    private double spread = 180;
    @Param(doc = "angle between two beams", unit = "deg", min = 0.01, max = 360)
    private double resolution = 1;
    @Included
    private final SerialParameters serial = new SerialParameters(9600);
    @Param(doc = "device behind the ports: 1 SICK LMS200, 0 none", values = {"0", "1"}, max = 1)
    private int lms = 1;
    @Param(doc = "whether the LMS200 obeys the baud telegrams with a wrong checksum that MyRobotLab's old driver sends")
    private boolean lenient;
    @Param(doc = "whether its beams see parts of the own robot")
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
    public LIDAR(String name, double range, double spread, double resolution, double x, double y, double z, double rx, double ry, double rz) {
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
            faults.add("resolution", resolution, "at most " + MAX_BEAMS + " beams: at least " + Parameter.format(spread / (MAX_BEAMS - 1)) + " deg");
        }
    }

    /** Farthest distance, metres. */
    public double getRange() {
        return range;
    }

    /** Angle from the rightmost to the leftmost beam, degrees. */
    public double getSpread() {
        return spread;
    }

    /** Angle between two beams, degrees. */
    public double getResolution() {
        return resolution;
    }

    @Override
    public String getUartPort() {
        return serial.getUartPort();
    }

    @Override
    public String getUserPort() {
        return serial.getUserPort();
    }

    @Override
    public int getBaud() {
        return serial.getBaud();
    }

    /** 1 for a SICK LMS200 behind the ports, 0 for none. */
    public int getLms() {
        return lms;
    }

    /** Whether its beams see parts of the own robot. */
    public boolean isSeesOwnRobot() {
        return seesOwnRobot;
    }

    /**
     * Puts the device behind a port: an LMS200 unless {@link #LMS} says otherwise, which has only some fans.
     *
     * @param uart the device's end
     * @param user the end that the user opens
     * @throws IllegalArgumentException if no LMS200 has the fan; without ports every fan is legal
     */
    public void setPorts(String uart, String user) {
        if (uart != null) {
            checkFan(lms);
        }
        serial.setPorts(this, uart, user);
    }

    private void checkFan(int type) {
        if (type == 1 && Variant.ofDegrees(spread, resolution) == null) {
            throw new IllegalArgumentException(noSuchFan());
        }
    }

    private String noSuchFan() {
        return label() + ": at a port there is an LMS200, and none has spread " + Parameter.format(spread) + " with resolution "
            + Parameter.format(resolution) + " deg, legal: 100 with 1, 0.5 or 0.25; 180 with 1 or 0.5; without setPorts every fan, read by"
            + " sear.getLidarResult(\"" + getName() + "\")";
    }

    /** The fan has changed. What is wrong now may be right when the other half of it is changed, too, so this is no error. */
    private void fanChanged() {
        changed();
        if (serial.getUartPort() != null && lms == 1 && Variant.ofDegrees(spread, resolution) == null) {
            Notices.say(noSuchFan() + "; until that is changed its device starts with 180 and 0.5");
        }
    }

    /** @param metres 0.01 to 10000 */
    public void setRange(double metres) {
        range = checked("range", metres);
        changed();
    }

    /**
     * Warns at once if an LMS200 at a port can't do it.
     *
     * @param degrees from the rightmost to the leftmost beam, 0.01 to 360
     */
    public void setSpread(double degrees) {
        spread = checked("spread", degrees);
        fanChanged();
    }

    /**
     * Warns at once if an LMS200 at a port can't do it.
     *
     * @param degrees between two beams, 0.01 to 360
     */
    public void setResolution(double degrees) {
        resolution = checked("resolution", degrees);
        fanChanged();
    }

    @Override
    public String getExport() {
        return serial.getExport();
    }

    /**
     * Has every start of a simulation export the user's port; the export stays while the simulation is stopped.
     *
     * @param target the name of a link in the folder SEARports, for example {@code ttySICK}; or {@code tcp:5001} or {@code rfc2217:5001}, a port of
     *     this computer; null for nowhere
     */
    public void setExport(String target) {
        serial.setExport(this, target);
    }

    /** @param port raw bytes at this TCP port of this computer, 1024 to 65535 */
    public void setExport(int port) {
        serial.setExport(this, "tcp:" + port);
    }

    /** @param newBaud speed at power-on, 300 to 1000000 */
    public void setBaud(int newBaud) {
        serial.setBaud(this, newBaud);
    }

    /** @param type 1 for a SICK LMS200 behind the ports, 0 for none */
    public void LMS(int type) {
        int wanted = checked("lms", type);
        if (serial.getUartPort() != null) {
            checkFan(wanted);
        }
        lms = wanted;
        changed();
    }

    /** Whether its beams see parts of the own robot; false at first. */
    public void setSeesOwnRobot(boolean on) {
        seesOwnRobot = checked("seesOwnRobot", on);
        changed();
    }

    /** Whether the LMS200 obeys the baud telegrams with a wrong checksum that MyRobotLab's old driver sends: a real one answers NAK. At first not. */
    public boolean isLenient() {
        return lenient;
    }

    public void setLenient(boolean obey) {
        lenient = checked("lenient", obey);
        changed();
    }
}
