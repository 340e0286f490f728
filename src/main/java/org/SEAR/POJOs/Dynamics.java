// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Included;
import org.SEAR.grammar.Param;

/**
 * Mass, suspension and start pose of a robot, and its serial port for the Roomba protocol. The pose is relative to the
 * robot's.
 */
@Described("mass, suspension and start pose of a robot, relative to the robot's own pose, and its serial port for the "
    + "Roomba protocol. SEAR sets an upside-down start pose upright and turns it by 180 degrees, with a warning")
public class Dynamics extends SearObject implements SerialObject {
    private static final double COMPRESSION = 0.3;
    private static final double DAMPING = 0.4;
    private static final double MAX_FORCE = 10000;

    @Param(doc = "mass of the whole robot", unit = "kg", min = 0.001, max = Shape.HEAVY, required = true, initial = "3")
    private double mass;
    @Param(doc = "spring rate of a wheel in N/m per kg of the robot; default: springs sag by a tenth of the smallest "
        + "wheel's radius, at most 1 cm", unit = "1/s^2", max = 1e6)
    private Double stiffness;
    @Param(doc = "damping ratio while the suspension is compressed")
    private double compression = COMPRESSION;
    @Param(doc = "damping ratio while the suspension extends")
    private double damping = DAMPING;
    @Param(doc = "largest force of a wheel's suspension; without stiffness at least ten times the wheel's load",
        unit = "N", max = 1e9)
    private double maxSuspensionForce = MAX_FORCE;
    @Param(doc = "length of the unloaded suspension; default 0.1 with stiffness, otherwise so that the robot stands "
        + "level and clear of the ground", unit = "m", max = 100)
    private Double restLength;
    @Included
    private final SerialParameters serial = new SerialParameters(this, 57600);
    @Param(doc = "firmware at the port", values = {"roomba400", "create", "create2"})
    private String model = "create";
    @Param(doc = "whether the checksum of a sensor stream covers header byte 19: true as in the Create 2 document, "
        + "false as in the Create's")
    private boolean streamHeaderSummed = true;
    @Param(doc = "errors of wheels, encoders and steering; default none")
    private DriveErrors errors;
    @Param(doc = "centre of mass and inertia tensor; default those of the components")
    private Inertia inertia;

    /** For reading from a file. */
    protected Dynamics() {
    }

    /**
     * At the origin, with a suspension that fits the robot.
     *
     * @param mass kg
     */
    public Dynamics(String name, double mass) {
        this(name, mass, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z), metres, turned by (rx, ry, rz), degrees, with a suspension that fits the robot. */
    public Dynamics(String name, double mass, double x, double y, double z, double rx, double ry, double rz) {
        this(name, mass, null, COMPRESSION, DAMPING, MAX_FORCE, null, x, y, z, rx, ry, rz);
    }

    /** At the origin. */
    public Dynamics(String name, double mass, double stiffness, double compression, double damping,
        double maxSuspensionForce, double restLength) {
        this(name, mass, stiffness, compression, damping, maxSuspensionForce, restLength, 0, 0, 0, 0, 0, 0);
    }

    /**
     * With all parameters.
     *
     * @param maxSuspensionForce N
     * @param restLength metres
     */
    public Dynamics(String name, double mass, double stiffness, double compression, double damping,
        double maxSuspensionForce, double restLength, double x, double y, double z, double rx, double ry, double rz) {
        this(name, mass, Double.valueOf(stiffness), compression, damping, maxSuspensionForce,
            Double.valueOf(restLength), x, y, z, rx, ry, rz);
    }

    private Dynamics(String name, double mass, Double stiffness, double compression, double damping,
        double maxSuspensionForce, Double restLength, double x, double y, double z, double rx, double ry, double rz) {
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

    public double getMass() {
        return mass;
    }

    /** Returns the stiffness, 1/s^2 (N/m per kg of the robot); null for one that fits the robot. */
    public Double getStiffness() {
        return stiffness;
    }

    public double getCompression() {
        return compression;
    }

    public double getDamping() {
        return damping;
    }

    public double getMaxSuspensionForce() {
        return maxSuspensionForce;
    }

    /** Returns the length of the unloaded suspension, metres; null for one that fits the robot. */
    public Double getRestLength() {
        return restLength;
    }

    @Override
    public SerialParameters getSerial() {
        return serial;
    }

    public String getModel() {
        return model;
    }

    /** @param newModel roomba400, create or create2 */
    public void setModel(String newModel) {
        model = checked("model", newModel);
        changed();
    }

    /**
     * Returns whether the checksum of a sensor stream covers the header byte 19: true as in the Create 2 document
     * (2016), false as printed in that of the Create (2006).
     */
    public boolean isStreamHeaderSummed() {
        return streamHeaderSummed;
    }

    public void setStreamHeaderSummed(boolean summed) {
        streamHeaderSummed = checked("streamHeaderSummed", summed);
        changed();
    }

    /** Returns the errors of wheels, encoders and steering; null for none. */
    public DriveErrors getErrors() {
        return errors;
    }

    /** @param newErrors errors of wheels, encoders and steering; null for none */
    public void setErrors(DriveErrors newErrors) {
        checkChangeable();
        errors = newErrors;
        changed();
    }

    /** Returns centre of mass and inertia tensor; null for those of the components. */
    public Inertia getInertia() {
        return inertia;
    }

    /** @param newInertia centre of mass and inertia tensor; null for those of the components */
    public void setInertia(Inertia newInertia) {
        checkChangeable();
        inertia = newInertia;
        changed();
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (inertia != null && !inertia.isPositive()) {
            faults.add("inertia", "a tensor with a negative or no principal moment", "positive principal moments");
        }
    }

    /**
     * Sets the typical errors of a ready robot.
     *
     * @param preset see {@link DriveErrors#of}
     */
    public void setErrors(String preset) {
        setErrors(DriveErrors.of(preset));
    }
}
