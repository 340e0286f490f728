// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.devices.PinState;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.Robot;
import org.SEAR.robot.Stability;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.BeamFans;
import org.SEAR.scene.Glow;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.scene.ViewCone;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Snapshot;
import org.myrobotlab.service.sear.readings.EulerAngles;

/**
 * Converts the state of the world for panels. Stores each robot's path. {@link WorldFeed} adds the fields of a running
 * simulation. Simulation thread.
 */
final class WorldJson {
    private static final double FINE = 1e4;
    /** Resolution of numbers: seven digits of a degree are a centimetre on Earth. */
    private static final double FINEST = 1e8;
    private static final double MILLIMETRES = 1e3;
    private static final double ANGLE = 1e3;
    private static final double PATH_STEP = 0.02;
    private static final int LONGEST_PATH = 500;

    private final Map<String, List<double[]>> paths = new LinkedHashMap<>();
    private final LookTable looks;
    private final boolean looking;
    private Project project;
    private ReadingTexts texts;
    private double lastTime;

    WorldJson(LookTable looks) {
        this(looks, false);
    }

    /** @param looking whether cameras take pictures; otherwise panels request them, see {@link CameraPicture} */
    WorldJson(LookTable looks, boolean looking) {
        this.looks = looks;
        this.looking = looking;
    }

    /** Fills in the whole world, without the fields of a running simulation. */
    synchronized <T extends WorldState> T whole(Simulation world, T state) {
        moving(world, state);
        looks.begin(world);
        for (int i = 0; i < state.objects.size(); i++) {
            addFixed(state.objects.get(i), world.getProject().getEnvironment().get(i), world);
        }
        int sensor = 0;
        for (int i = 0; i < state.robots.size(); i++) {
            Robot robot = world.getRobots().get(i);
            addFixed(state.robots.get(i), robot, world);
            for (Sensor<?> one : robot.getSensors()) {
                addFixed(state.sensors.get(sensor++), robot, one, world);
            }
        }
        for (BeamFan fan : BeamFans.of(world.getProject())) {
            state.sensors.stream().filter(probe -> probe.ranges != null && probe.name.equals(fan.sensor)).forEach(probe -> probe.fan = fan(fan));
        }
        return state;
    }

    /** Fills in the fields that can change in each step, in the same order as the whole state. */
    synchronized <T extends WorldState> T moving(Simulation world, T state) {
        Snapshot snapshot = world.snapshot();
        List<String> names = world.getSensorNames().stream()
            .filter(name -> looking || !(world.getSensor(name).getParameters() instanceof Camera)).collect(Collectors.toList());
        List<Reading> read = world.read(names);
        Map<String, Reading> readings = new LinkedHashMap<>();
        for (int i = 0; i < read.size(); i++) {
            readings.put(names.get(i), read.get(i));
        }
        begin(world.getProject());
        if (snapshot.time < lastTime) {
            paths.clear();
        }
        lastTime = snapshot.time;
        state.time = snapshot.time;
        state.step = snapshot.step;
        for (Pose pose : snapshot.environment) {
            WorldState.Thing thing = new WorldState.Thing();
            thing.pose = numbers(pose);
            state.objects.add(thing);
        }
        for (int i = 0; i < world.getRobots().size(); i++) {
            Robot robot = world.getRobots().get(i);
            state.robots.add(mover(robot, snapshot.robots.get(i)));
            robot.getSensors().forEach(sensor -> state.sensors.add(probe(robot, sensor, readings.get(sensor.getName()))));
        }
        return state;
    }

    private void begin(Project of) {
        if (of != project) {
            project = of;
            texts = new ReadingTexts(of);
        }
    }

    private void addFixed(WorldState.Thing thing, SearObject object, Simulation world) {
        thing.name = object.getName();
        thing.type = object.getClass().getSimpleName();
        thing.corners = corners(world.getOutline(object));
        if (object instanceof Shape) {
            looks.add(thing, (Shape) object, world);
            thing.color = ((Shape) object).getColor();
            thing.loose = ((Shape) object).getMass() > 0;
            thing.colored = ((Shape) object).hasColor();
        }
        if (object instanceof Model) {
            thing.terrain = ((Model) object).isTerrain();
        }
        if (object instanceof Floor && ((Floor) object).getImage() != null) {
            thing.tile = Optional.ofNullable(((Floor) object).getPictureTile()).orElse(0.0);
        }
        if (object instanceof Terrain) {
            thing.ground = ground(world.getProject());
        }
    }

    private void addFixed(WorldState.Mover mover, Robot robot, Simulation world) {
        mover.name = robot.getObject().getName();
        mover.radius = rounded(robot.getHardware().getBodyRadius(), FINE);
        mover.drives = robot.getHardware().getWheelRadius() > 0;
        mover.turns = robot.getHardware().getWheelBase() > 0;
        mover.steered = SteeringKeys.of(robot.getObject());
        mover.path = new ArrayList<>(paths.get(mover.name));
        mover.parts = parts(world, robot);
        mover.leds = mover.lights == null ? null : lamps(robot);
        mover.balance = balance(robot.getStability());
    }

    private static String ground(Project project) {
        try {
            return TerrainMap.stamp(project);
        } catch (ProjectException e) {
            throw new IllegalStateException("a world was made of it: " + e.getMessage(), e);
        }
    }

    private static double[][] corners(double[][] exact) {
        double[][] corners = new double[exact.length][];
        for (int i = 0; i < exact.length; i++) {
            corners[i] = point(exact[i], FINE);
        }
        return corners;
    }

    private static double[] point(double[] exact, double per) {
        return new double[] {rounded(exact[0], per), rounded(exact[1], per), rounded(exact[2], per)};
    }

    private WorldState.Mover mover(Robot robot, Snapshot.RobotState now) {
        WorldState.Mover mover = new WorldState.Mover();
        SEARrobot written = robot.getWritten();
        mover.pose = numbers(now.pose);
        mover.start = numbers(robot.getStart());
        mover.written = new double[] {written.getX(), written.getY(), written.getZ(), written.getRx(), written.getRy(), written.getRz()};
        mover.speed = rounded(now.speed, FINE);
        mover.turnRate = rounded(now.turnRate, FINE);
        mover.devices = devices(now.devices);
        mover.wheels = wheels(now.wheels);
        mover.turned = now.parts.isEmpty() ? null : turned(robot.getObject(), now.parts, Shape.class);
        mover.lights = now.lights.isEmpty() ? null : now.lights;
        mover.turnedLeds = now.parts.isEmpty() || now.lights.isEmpty() ? null : turned(robot.getObject(), now.parts, Led.class);
        extendPath(now);
        return mover;
    }

    /** Returns the rotated wheels' poses in the body, in their order among the parts. */
    private static double[][] wheels(List<Pose> poses) {
        double[][] all = new double[poses.size()][];
        for (int i = 0; i < all.length; i++) {
            all[i] = numbers(poses.get(i));
        }
        return all;
    }

    /** Returns the poses of one kind of parts in the body, as turned by servos. */
    private static double[][] turned(SEARrobot robot, List<Pose> poses, Class<? extends SearObject> kind) {
        List<double[]> list = new ArrayList<>();
        for (int i = 0; i < poses.size(); i++) {
            if (kind.isInstance(robot.getComponents().get(i))) {
                list.add(numbers(poses.get(i)));
            }
        }
        return list.toArray(new double[0][]);
    }

    private static List<WorldState.Pin> pins(List<PinState> states) {
        List<WorldState.Pin> list = new ArrayList<>();
        for (PinState state : states) {
            WorldState.Pin pin = new WorldState.Pin();
            pin.pin = state.pin;
            pin.wired = state.wired;
            pin.mode = state.mode;
            pin.value = state.value;
            list.add(pin);
        }
        return list;
    }

    private static List<WorldState.Device> devices(List<Snapshot.DeviceState> states) {
        List<WorldState.Device> list = new ArrayList<>();
        for (Snapshot.DeviceState state : states) {
            WorldState.Device device = new WorldState.Device();
            device.name = state.name;
            device.on = state.powered;
            device.status = state.status;
            device.pins = state.pins.isEmpty() ? null : pins(state.pins);
            list.add(device);
        }
        return list;
    }

    private List<WorldState.Thing> parts(Simulation world, Robot robot) {
        List<SearObject> visible = new ArrayList<>();
        robot.getObject().getComponents().stream().filter(part -> part instanceof Shape).forEach(visible::add);
        visible.addAll(robot.getObject().getWheels());
        List<WorldState.Thing> list = new ArrayList<>();
        for (SearObject part : visible) {
            WorldState.Thing thing = new WorldState.Thing();
            thing.pose = numbers(ObjectPose.of(part));
            addFixed(thing, part, world);
            if (part instanceof Wheel) {
                thing.driven = ((Wheel) part).isDriven();
                thing.motor = motorOf(part.getName(), robot.getObject());
            }
            list.add(thing);
        }
        return list;
    }

    private static String motorOf(String wheel, SEARrobot robot) {
        return robot.getComponents().stream().filter(part -> part instanceof Motor && ((Motor) part).getWheelNames().contains(wheel))
            .map(SearObject::getName).findFirst().orElse(null);
    }

    private static List<WorldState.Lamp> lamps(Robot robot) {
        List<WorldState.Lamp> list = new ArrayList<>();
        for (SearObject part : robot.getObject().getComponents()) {
            if (part instanceof Led) {
                WorldState.Lamp lamp = new WorldState.Lamp();
                lamp.pose = numbers(ObjectPose.of(part));
                lamp.name = part.getName();
                lamp.color = ((Led) part).getColor();
                lamp.dark = Glow.of(lamp.color, 0);
                lamp.size = ((Led) part).getSize();
                list.add(lamp);
            }
        }
        return list;
    }

    private static WorldState.Balance balance(Stability stability) {
        WorldState.Balance balance = new WorldState.Balance();
        balance.centre = point(stability.getCentre(), FINE);
        balance.support = corners(stability.getSupport());
        balance.critical = stability.isCritical();
        balance.words = stability.getWords();
        return balance;
    }

    /** Extends a robot's path; panels do the same with the poses they get. */
    private void extendPath(Snapshot.RobotState robot) {
        List<double[]> path = paths.computeIfAbsent(robot.name, name -> new ArrayList<>());
        double[] last = path.isEmpty() ? null : path.get(path.size() - 1);
        if (last == null || Math.hypot(last[0] - robot.pose.x, last[1] - robot.pose.z) > PATH_STEP) {
            path.add(new double[] {rounded(robot.pose.x, FINE), rounded(robot.pose.z, FINE)});
        }
        if (path.size() > LONGEST_PATH) {
            for (int i = path.size() - 2; i > 0; i -= 2) {
                path.remove(i);
            }
        }
    }

    private static void addFixed(WorldState.Probe probe, Robot robot, Sensor<?> of, Simulation world) {
        SearObject sensor = of.getParameters();
        probe.name = sensor.getFullName();
        probe.type = sensor.getClass().getSimpleName();
        probe.robot = robot.getObject().getName();
        probe.unit = world.getUnit(of.getName());
        probe.names = sensor instanceof Camera ? CameraImage.names(((Camera) sensor).getKind()) : world.read(of.getName()).names();
        probe.eye = sensor instanceof Camera ? eye((Camera) sensor) : null;
        probe.cones = sensor instanceof Distance ? cones((Distance) sensor) : null;
    }

    private static WorldState.EyeForm eye(Camera camera) {
        WorldState.EyeForm form = new WorldState.EyeForm();
        form.kind = camera.getKind();
        form.width = camera.getWidth();
        form.height = camera.getHeight();
        form.edge = ViewCone.edge(camera);
        return form;
    }

    private static List<float[]> fan(BeamFan of) {
        List<float[]> directions = new ArrayList<>(of.size());
        for (int i = 0; i < of.size(); i++) {
            directions.add(Arrays.copyOfRange(of.directions, 3 * i, 3 * i + 3));
        }
        return directions;
    }

    private static List<WorldState.BeamForm> cones(Distance sensor) {
        List<WorldState.BeamForm> list = new ArrayList<>();
        for (BeamCone cone : sensor.getCones()) {
            WorldState.BeamForm form = new WorldState.BeamForm();
            form.halfAngle = cone.getHalfAngle();
            form.range = cone.getRange();
            form.yaw = cone.getYaw();
            list.add(form);
        }
        return list;
    }

    private WorldState.Probe probe(Robot robot, Sensor<?> sensor, Reading reading) {
        WorldState.Probe probe = new WorldState.Probe();
        probe.pose = numbers(robot.getPose().times(sensor.getMount()));
        if (sensor.getParameters() instanceof Camera) {
            addSeen(probe, (Camera) sensor.getParameters(), reading);
            return probe;
        }
        LidarScan scan = reading.scan();
        if (scan == null) {
            probe.value = Optional.ofNullable(reading.value());
        } else {
            probe.ranges = new ScanRanges(scan.ranges());
        }
        if (reading.hits() != null) {
            probe.hit = reading.hits().stream().findFirst().map(hit -> point(hit, MILLIMETRES));
        }
        probe.words = texts.of(sensor.getName(), reading);
        probe.numbers = numbers(reading.numbers());
        probe.picture = reading.picture() == null ? null : SmallPicture.of(reading.picture());
        return probe;
    }

    /**
     * Fills in a camera without its pixels: they are too many, and the picture shows them.
     *
     * @param reading null without a picture
     */
    private static void addSeen(WorldState.Probe probe, Camera camera, Reading reading) {
        if (reading == null) {
            probe.words = camera.getWidth() + " x " + camera.getHeight();
            probe.numbers = new ArrayList<>(Collections.nCopies(CameraImage.names(camera.getKind()).size(), null));
        } else {
            probe.words = reading.words("");
            probe.numbers = numbers(reading.numbers());
            probe.picture = SmallPicture.of(reading.picture());
        }
    }

    /** Returns a reading's numbers; null for NaN and infinity. */
    static List<Double> numbers(double[] exact) {
        List<Double> numbers = new ArrayList<>(exact.length);
        for (double number : exact) {
            numbers.add(Double.isNaN(number) || Double.isInfinite(number) ? null : Double.valueOf(rounded(number, FINEST)));
        }
        return numbers;
    }

    private static double[] numbers(Pose pose) {
        double[] angles = EulerAngles.degrees(pose);
        return new double[] {rounded(pose.x, FINE), rounded(pose.y, FINE), rounded(pose.z, FINE), rounded(angles[0], ANGLE),
            rounded(angles[1], ANGLE), rounded(angles[2], ANGLE)};
    }

    static double rounded(double value, double per) {
        return Double.isNaN(value) || Double.isInfinite(value) ? 0 : Math.round(value * per) / per;
    }
}
