// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.devices.Cable;
import org.SEAR.devices.DeviceTypes;
import org.SEAR.devices.SerialDevice;
import org.SEAR.devices.SerialLine;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Pose;
import org.SEAR.project.PartNames;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.Hit;
import org.SEAR.robot.RobotModel;
import org.SEAR.sensors.LidarSensor;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.SensorTypes;
import org.SEAR.sensors.ParallelSensing;

/** Sensors of all robots, readings of joints, and the devices on their serial ports. Simulation thread. */
final class Instruments {
    private final List<RobotModel> robots;
    private final WorldJoints joints;
    private final PartNames<Sensor<?>> sensors = new PartNames<>();
    private final Map<Sensor<?>, RobotModel> carriers = new IdentityHashMap<>();
    private final List<DevicePort> ports = new ArrayList<>();
    private final List<SerialLine> lines = new ArrayList<>();
    private final PartNames<Cable> devices = new PartNames<>();
    private final List<String> names;
    private final SensorTypes types = SensorTypes.load();
    private final Assets assets;
    private final BiConsumer<String, String> warnings;
    private final ParallelSensing sideBySide;
    private final List<DevicePort> scanners = new ArrayList<>();

    Instruments(World world, Assets assets, long seed, BiConsumer<String, String> warnings) {
        sideBySide = new ParallelSensing(world.getWorkers());
        robots = world.getRobots();
        joints = world.getJoints();
        this.assets = assets;
        this.warnings = warnings;
        DeviceTypes deviceTypes = DeviceTypes.load();
        for (RobotModel robot : robots) {
            robot.truth().setWrenches(joints.wrenches(robot.getObject().getName()));
            for (SearObject part : robot.getObject().getComponents()) {
                if (types.isSensor(part)) {
                    Sensor<?> sensor = types.create(part, seed);
                    robot.add(sensor);
                    sensors.add(robot.getObject().getName(), part.getName(), sensor);
                    carriers.put(sensor, robot);
                }
            }
            for (SearObject part : robot.getObject().getComponents()) {
                connect(part, robot, seed, deviceTypes);
            }
        }
        names = carriers.keySet().stream().map(Sensor::getName).sorted().collect(Collectors.toUnmodifiableList());
    }

    /** Connects a part's device to its ports. A device can reach all sensors of its robot. */
    private void connect(SearObject part, RobotModel robot, long seed, DeviceTypes types) {
        if (!(part instanceof SerialObject) || ((SerialObject) part).getUartPort() == null || ((SerialObject) part)
            .getUserPort() == null) {
            return;
        }
        if (!types.isKnown(part)) {
            return;
        }
        Sensor<?> sensor = robot.getSensors().stream().filter(each -> each.getParameters() == part).findFirst()
            .orElse(null);
        DevicePort port = new DevicePort(part, robot, sensor, seed, assets, warnings);
        SerialDevice device = types.create(part, port);
        if (device != null) {
            port.getCable().attach(device);
            ports.add(port);
            if (sensor instanceof LidarSensor) {
                scanners.add(port);
            }
            devices.add(robot.getObject().getName(), part.getName(), port.getCable());
            lines.add(port.getCable());
        }
    }

    /** Sets the seed of random numbers from the next restart on. */
    void reseed(long seed) {
        carriers.keySet().forEach(sensor -> sensor.reseed(seed));
        ports.forEach(port -> port.reseed(seed));
    }

    /** Restarts all sensors and devices, as after power-on. */
    void restart() {
        for (RobotModel robot : robots) {
            for (Sensor<?> sensor : robot.getSensors()) {
                sensor.reset();
            }
        }
        for (DevicePort port : ports) {
            port.getCable().restart();
        }
    }

    /** Warns of sensors that can't work in this world, for example inside another object. */
    void warn() {
        Hit hit = new Hit();
        for (RobotModel robot : robots) {
            for (Sensor<?> sensor : robot.getSensors()) {
                sensor.warnings(robot.truth()).forEach(this::warn);
                Pose pose = robot.getPose().times(sensor.getMount());
                double[] ahead = pose.rotate(0, 0, 1);
                BeamScene scene = robot.truth().scene();
                double distance = scene.cast(pose.x, pose.y, pose.z, ahead[0], ahead[1], ahead[2], Double.MAX_VALUE,
                    robot.getOwner(), hit);
                if (distance < Double.POSITIVE_INFINITY && ahead[0] * hit.nx + ahead[1] * hit.ny
                    + ahead[2] * hit.nz > 0) {
                    warn("sensor " + sensor.getName() + " is inside " + robot.truth().objectName(hit.shape)
                        + "; move one of them");
                }
            }
        }
    }

    private void warn(String message) {
        warnings.accept(message, message);
    }

    /** Commands phase: takes the bytes that hosts have written. */
    void accept(double time) {
        for (int i = 0; i < ports.size(); i++) {
            ports.get(i).getCable().accept(time);
        }
    }

    /** Sensors phase: sensors with a memory observe the step. */
    void track() {
        for (int i = 0; i < robots.size(); i++) {
            RobotModel robot = robots.get(i);
            for (int k = 0; k < robot.getSensors().size(); k++) {
                robot.getSensors().get(k).track(robot.truth());
            }
        }
    }

    /**
     * Devices phase: measures the expected scans in parallel, then runs each device in turn.
     *
     * @param end simulated time of the step's end, s
     */
    void run(double end) {
        for (int i = 0; i < scanners.size(); i++) {
            DevicePort port = scanners.get(i);
            sideBySide.scan((LidarSensor) port.sensor(), port.truth(), end);
        }
        boolean ahead = sideBySide.scanAhead();
        try {
            for (int i = 0; i < ports.size(); i++) {
                ports.get(i).getCable().run(end);
            }
        } finally {
            for (int i = 0; ahead && i < scanners.size(); i++) {
                ((LidarSensor) scanners.get(i).sensor()).forgetAhead();
            }
        }
    }

    /**
     * Outputs phase: delivers replies to the host ports.
     *
     * @param end simulated time of the step's end, s
     */
    void deliver(double end) {
        for (int i = 0; i < ports.size(); i++) {
            DevicePort port = ports.get(i);
            port.getCable().deliver(end);
            port.warnOfLosses();
        }
    }

    /**
     * Services lines and devices between two steps.
     *
     * @param time simulated seconds
     * @return simulated time of the next service, s; infinity if there was nothing to do
     */
    double serviceDevices(double time) {
        double next = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ports.size(); i++) {
            next = Math.min(next, ports.get(i).getCable().serviceDevice(time));
        }
        return next;
    }

    /** Simulated time at which a device acts next by itself, s; infinity if all may wait for the step. */
    double nextAction() {
        double next = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ports.size(); i++) {
            next = Math.min(next, ports.get(i).getCable().nextAction());
        }
        return next;
    }

    /** Whether a device that answers at once has a query. Any thread. */
    boolean hasQueries() {
        for (int i = 0; i < ports.size(); i++) {
            if (ports.get(i).getCable().hasQueries()) {
                return true;
            }
        }
        return false;
    }

    /** Whether a port is just being opened, see {@link org.SEAR.devices.Cable#isOpening}. Any thread. */
    boolean areOpening() {
        for (int i = 0; i < ports.size(); i++) {
            if (ports.get(i).getCable().isOpening()) {
                return true;
            }
        }
        return false;
    }

    /** Lets devices that answer at once do so while time stands still. */
    void answer(double time) {
        for (int i = 0; i < ports.size(); i++) {
            if (ports.get(i).getCable().hasQueries()) {
                ports.get(i).getCable().answer(time);
            }
        }
    }

    Sensor<?> sensor(String name) {
        Sensor<?> sensor = sensors.find(name);
        if (sensor == null) {
            throw new IllegalArgumentException("no sensor is called \"" + name + "\", legal: "
                + (names.isEmpty() ? "none, the project has no sensors" : String.join(", ", names)));
        }
        return sensor;
    }

    void power(String name, boolean on, double time) {
        Cable cable = devices.find(name);
        if (cable == null) {
            throw new IllegalArgumentException("no device is called \"" + name + "\", legal: " + (lines.isEmpty()
                ? "none, no object of the project has ports" : lines.stream().map(SerialLine::getObjectName)
                    .collect(Collectors.joining(", "))));
        }
        cable.setPowered(on, time);
    }

    Reading read(String name) {
        if (joints.isRead(name)) {
            return joints.reading(name);
        }
        Sensor<?> sensor = sensor(name);
        return sensor.read(carriers.get(sensor).truth());
    }

    List<Reading> read(Collection<String> some) {
        List<Sensor<?>> found = some.stream().filter(name -> !joints.isRead(name)).map(this::sensor)
            .collect(Collectors.toList());
        found.forEach(sensor -> sideBySide.read(sensor, carriers.get(sensor).truth()));
        sideBySide.measure();
        return some.stream().map(this::read).collect(Collectors.toList());
    }

    String unit(String name) {
        return joints.isRead(name) ? joints.reading(name).unit() : types.unit(sensor(name).getParameters());
    }

    List<String> getNames() {
        return names;
    }

    List<SerialLine> getLines() {
        return Collections.unmodifiableList(lines);
    }

    List<DevicePort> getPorts() {
        return ports;
    }
}
