package org.SEAR.POJOs;

/** Mass, suspension and start pose of a robot, and its serial port, which speaks the Roomba protocol. The pose counts from the robot's own. */
@Described("mass, suspension and start pose of a robot (in the world, or from where the robot was moved to), and its serial port, which speaks the"
    + " Roomba protocol. A start pose that lies on its back is set upright and turned by 180 degrees, with a warning")
public class Dynamics extends SearObject implements SerialObject {
    private static final double STIFFNESS = 60;
    private static final double COMPRESSION = 0.3;
    private static final double DAMPING = 0.4;
    private static final double MAX_FORCE = 10000;
    private static final double REST_LENGTH = 0.1;

    @Param(doc = "mass of the whole robot", unit = "kg", min = 0.001, max = Shape.HEAVY, required = true, initial = "3")
    private double mass;
    @Param(doc = "stiffness of the suspension, in Bullet's measure", unit = "1/s^2", max = 1e6)
    private double stiffness = STIFFNESS;
    @Param(doc = "damping while the suspension is compressed, as a share of the critical one")
    private double compression = COMPRESSION;
    @Param(doc = "damping while the suspension is released, as a share of the critical one")
    private double damping = DAMPING;
    @Param(doc = "largest force of a wheel's suspension", unit = "N", max = 1e9)
    private double maxSuspensionForce = MAX_FORCE;
    @Param(doc = "length of the suspension at rest", unit = "m", max = 100)
    private double restLength = REST_LENGTH;
    @Included
    private final SerialParameters serial = new SerialParameters(this, 57600);
    @Param(doc = "whose firmware answers at the port", values = {"roomba400", "create", "create2"})
    private String model = "create";
    @Param(doc = "whether the checksum of a sensor stream covers the header byte 19: true as in the Create 2 document, false as in the Create's")
    private boolean streamHeaderSummed = true;

    /** For reading from a file. */
    protected Dynamics() {
    }

    /**
     * With the suspension of the dissertation's Roomba, at the origin.
     *
     * @param mass kg
     */
    public Dynamics(String name, double mass) {
        this(name, mass, 0, 0, 0, 0, 0, 0);
    }

    /** With the suspension of the dissertation's Roomba, starting at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Dynamics(String name, double mass, double x, double y, double z, double rx, double ry, double rz) {
        this(name, mass, STIFFNESS, COMPRESSION, DAMPING, MAX_FORCE, REST_LENGTH, x, y, z, rx, ry, rz);
    }

    /** At the origin. */
    public Dynamics(String name, double mass, double stiffness, double compression, double damping, double maxSuspensionForce, double restLength) {
        this(name, mass, stiffness, compression, damping, maxSuspensionForce, restLength, 0, 0, 0, 0, 0, 0);
    }

    /**
     * With everything.
     *
     * @param maxSuspensionForce N
     * @param restLength metres
     */
    public Dynamics(String name, double mass, double stiffness, double compression, double damping, double maxSuspensionForce,
            double restLength, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        this.mass = mass;
        this.stiffness = stiffness;
        this.compression = compression;
        this.damping = damping;
        this.maxSuspensionForce = maxSuspensionForce;
        this.restLength = restLength;
        pose(x, y, z, rx, ry, rz);
        created(Dynamics.class);
    }

    @Override
    boolean isRobotPart() {
        return true;
    }

    /** Mass of the whole robot, kg. */
    public double getMass() {
        return mass;
    }

    /** In Bullet's measure, 1/s^2. */
    public double getStiffness() {
        return stiffness;
    }

    /** Share of the critical damping while compressed. */
    public double getCompression() {
        return compression;
    }

    /** Share of the critical damping while released. */
    public double getDamping() {
        return damping;
    }

    /** N. */
    public double getMaxSuspensionForce() {
        return maxSuspensionForce;
    }

    /** Metres. */
    public double getRestLength() {
        return restLength;
    }

    @Override
    public SerialParameters getSerial() {
        return serial;
    }

    /** roomba400, create or create2. */
    public String getModel() {
        return model;
    }

    /** @param newModel roomba400, create or create2 */
    public void setModel(String newModel) {
        model = checked("model", newModel);
        changed();
    }

    /**
     * Whether the checksum of a sensor stream covers the header byte 19: true as in the Create 2 document (2016), false as printed in that of the
     * Create (2006). Default true.
     */
    public boolean isStreamHeaderSummed() {
        return streamHeaderSummed;
    }

    public void setStreamHeaderSummed(boolean summed) {
        streamHeaderSummed = checked("streamHeaderSummed", summed);
        changed();
    }
}
