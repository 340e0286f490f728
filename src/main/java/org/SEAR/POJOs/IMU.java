package org.SEAR.POJOs;

/** Yaw, pitch and roll, with accelerations, rates of turn and the magnetic field; behind its ports a Razor 9DOF. */
@Described("yaw, pitch and roll, accelerations, rates of turn, magnetic field; behind its ports a Razor 9DOF")
public class IMU extends SensorObject implements SerialObject {
    @Included
    private final SerialParameters serial = new SerialParameters(57600);

    /** For reading from a file. */
    protected IMU() {
    }

    /** At the body's origin. */
    public IMU(String name) {
        this(name, 0, 0, 0, 0, 0, 0);
    }

    /**
     * With ports.
     *
     * @param uart the device's end
     * @param user the end that the user opens
     */
    public IMU(String name, String uart, String user) {
        super(name);
        serial.setPorts(this, uart, user);
        created(IMU.class);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    public IMU(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        pose(x, y, z, rx, ry, rz);
        created(IMU.class);
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

    @Override
    public String getExport() {
        return serial.getExport();
    }

    /**
     * @param uart the device's end
     * @param user the end that the user opens
     */
    public void setPorts(String uart, String user) {
        serial.setPorts(this, uart, user);
    }

    /**
     * Has every start of a simulation export the user's port; the export stays while the simulation is stopped.
     *
     * @param target the name of a link in the folder SEARports; or {@code tcp:5001} or {@code rfc2217:5001}, a port of this computer; null for
     *     nowhere
     */
    public void setExport(String target) {
        serial.setExport(this, target);
    }

    /** @param port raw bytes at this TCP port of this computer, 1024 to 65535 */
    public void setExport(int port) {
        serial.setExport(this, "tcp:" + port);
    }

    /** @param newBaud speed of its line, 300 to 100000000 */
    public void setBaud(int newBaud) {
        serial.setBaud(this, newBaud);
    }
}
