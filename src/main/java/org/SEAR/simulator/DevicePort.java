// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.io.IOException;
import java.io.InputStream;
import java.util.function.BiConsumer;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.devices.Cable;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.RobotHardware;
import org.SEAR.files.Assets;
import org.SEAR.robot.RobotModel;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;

/** Access of one device's firmware to its line, robot and sensor. Simulation thread. */
final class DevicePort implements DeviceContext {
    private final Cable cable;
    private final RobotModel robot;
    private final Sensor<?> sensor;
    private long seed;
    private final Assets assets;
    private final BiConsumer<String, String> warnings;

    /** @param sensor null for a robot's drive */
    DevicePort(SearObject object, RobotModel robot, Sensor<?> sensor, long seed, Assets assets,
        BiConsumer<String, String> warnings) {
        SerialObject serial = (SerialObject) object;
        this.cable = new Cable(object.getFullName(), object.getClass().getSimpleName(), serial.getUartPort(),
            serial.getUserPort());
        this.robot = robot;
        this.sensor = sensor;
        this.seed = seed;
        this.assets = assets;
        this.warnings = warnings;
    }

    Cable getCable() {
        return cable;
    }

    RobotModel getRobot() {
        return robot;
    }

    @Override
    public void send(byte[] bytes, double time) {
        cable.send(bytes, time);
    }

    @Override
    public double lineFreeAt() {
        return cable.freeAt();
    }

    @Override
    public void clearOutput() {
        cable.clearOutput();
    }

    @Override
    public void cutOutput(double time) {
        cable.cutOutput(time);
    }

    @Override
    public void understood() {
        cable.understood();
    }

    @Override
    public RobotHardware robot() {
        return robot;
    }

    @Override
    public <R extends Reading> R read(Sensor<R> other) {
        return other.read(robot.truth());
    }

    @Override
    public Sensor<?> sensor() {
        return sensor;
    }

    @Override
    public Sensor<?> sensor(String part) {
        return robot.getSensors().stream().filter(each -> each.getParameters().getName().equals(part)).findFirst()
            .orElse(null);
    }

    @Override
    public byte[] asset(String path) throws IOException {
        try (InputStream in = assets.open(path)) {
            return in.readAllBytes();
        }
    }

    @Override
    public Truth truth() {
        return robot.truth();
    }

    @Override
    public double time() {
        return robot.truth().time();
    }

    @Override
    public long epochMillis() {
        return robot.truth().epochMillis();
    }

    @Override
    public long seed() {
        return seed;
    }

    void reseed(long newSeed) {
        seed = newSeed;
    }

    @Override
    public void warn(String cause, String message) {
        warnings.accept(cable.getObjectName() + ": " + cause, cable.getObjectName() + ": " + message);
    }

    /** Warns of bytes that overflowed a queue and of bytes that the device did not understand. */
    void warnOfLosses() {
        String complaint = cable.complaint(time());
        if (complaint != null) {
            warn(complaint.substring(complaint.indexOf(' ')), complaint);
        }
        if (cable.takeDropped() > 0) {
            warn("input", "a program writes faster to " + cable.getUserPort() + " than its line carries at "
                + cable.getDeviceBaud() + " baud; SEAR drops bytes while " + Cable.MAX_WAITING + " bytes wait");
        }
        if (cable.takeLost() > 0) {
            warn("output", "its replies exceed what its line carries at " + cable.getDeviceBaud()
                + " baud; SEAR drops replies while more than " + Cable.MAX_OUTPUT + " bytes wait");
        }
    }
}
