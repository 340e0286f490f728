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
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.Robot;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.BeamFans;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.scene.ViewCone;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Snapshot;

/**
 * Converts the state of the world for panels. Stores each robot's path. {@link WorldFeed} adds the fields of a running
 * simulation. Simulation thread.
 */
final class WorldJson {
    private static final double FINE = 1e4;
    private static final double MILLIMETRES = 1e3;
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
        JointJson.addFixed(world, state.joints);
        Map<String, WorldState.Probe> probes = state.sensors.stream()
            .collect(Collectors.toMap(probe -> probe.name, probe -> probe));
        for (BeamFan fan : BeamFans.of(world.getProject())) {
            WorldState.Probe probe = probes.get(fan.sensor);
            probe.fan = probe.ranges == null ? null : fan(fan);
            probe.cones = fan.cones.isEmpty() ? null : fan.cones.stream().map(WorldState.BeamForm::new)
                .collect(Collectors.toList());
        }
        ViewCone.of(world.getProject()).forEach(cone -> probes.get(cone.sensor).eye = new WorldState.EyeForm(cone));
        return state;
    }

    /** Fills in the fields that can change in each step, in the same order as the whole state. */
    synchronized <T extends WorldState> T moving(Simulation world, T state) {
        Snapshot snapshot = world.snapshot();
        List<String> names = world.getSensorNames().stream()
            .filter(name -> looking || !world.getSensor(name).takesPictures())
            .collect(Collectors.toList());
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
        snapshot.environment.forEach(pose -> state.objects.add(new WorldState.Thing(pose)));
        for (int i = 0; i < world.getRobots().size(); i++) {
            Robot robot = world.getRobots().get(i);
            state.robots.add(mover(robot, snapshot.robots.get(i)));
            robot.getSensors().forEach(sensor ->
                state.sensors.add(probe(robot, sensor, readings.get(sensor.getName()))));
        }
        state.joints.addAll(JointJson.moving(world));
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
        thing.corners = JsonNumbers.points(world.getOutline(object));
        double[][][] areas = world.getAreas(object);
        thing.areas = areas.length == 0 ? null : Arrays.stream(areas).map(JsonNumbers::points)
            .toArray(double[][][]::new);
        looks.add(thing, object, world);
        thing.more = object.getDrawingProperties();
        if (object instanceof Terrain) {
            thing.more.put("ground", ground(world.getProject()));
        }
    }

    private void addFixed(WorldState.Mover mover, Robot robot, Simulation world) {
        mover.name = robot.getObject().getName();
        mover.radius = JsonNumbers.rounded(robot.getHardware().getBodyRadius(), FINE);
        mover.drives = robot.getHardware().getWheelRadius() > 0;
        mover.turns = robot.getHardware().getTrack() > 0;
        mover.steered = SteeringKeys.of(robot.getObject());
        mover.path = new ArrayList<>(paths.get(mover.name));
        mover.parts = visibleParts(world, robot);
        mover.leds = mover.lights == null ? null : parts(robot, Led.class).map(WorldState.Lamp::new)
            .collect(Collectors.toList());
        mover.balance = new WorldState.Balance(robot.getStability());
    }

    private static String ground(Project project) {
        try {
            return TerrainMap.stamp(project);
        } catch (ProjectException e) {
            throw new IllegalStateException("a world was made of it: " + e.getMessage(), e);
        }
    }

    private WorldState.Mover mover(Robot robot, Snapshot.RobotState now) {
        WorldState.Mover mover = new WorldState.Mover();
        SEARrobot written = robot.getWritten();
        mover.pose = now.pose;
        mover.start = robot.getStart();
        mover.written = new double[] {written.getX(), written.getY(), written.getZ(), written.getRx(), written.getRy(),
            written.getRz()};
        mover.speed = JsonNumbers.rounded(now.speed, FINE);
        mover.turnRate = JsonNumbers.rounded(now.turnRate, FINE);
        mover.devices = now.devices.stream().map(WorldState.Device::new).collect(Collectors.toList());
        mover.wheels = now.wheels;
        mover.turned = now.parts.isEmpty() ? null : turned(robot.getObject(), now.parts, Shape.class);
        mover.lights = now.lights.isEmpty() ? null : now.lights;
        mover.turnedLeds = now.parts.isEmpty() || now.lights.isEmpty() ? null
            : turned(robot.getObject(), now.parts, Led.class);
        extendPath(now);
        return mover;
    }

    /** Returns the poses of one kind of parts in the body, as turned by servos. */
    private static List<Pose> turned(SEARrobot robot, List<Pose> poses, Class<? extends SearObject> kind) {
        return IntStream.range(0, poses.size()).filter(i -> kind.isInstance(robot.getComponents().get(i)))
            .mapToObj(poses::get)
            .collect(Collectors.toList());
    }

    private static <T extends SearObject> Stream<T> parts(Robot robot, Class<T> kind) {
        return robot.getObject().getComponents().stream().filter(kind::isInstance).map(kind::cast);
    }

    private List<WorldState.Thing> visibleParts(Simulation world, Robot robot) {
        return Stream.concat(parts(robot, Shape.class), robot.getObject().getWheels().stream()).map(part -> {
            WorldState.Thing thing = new WorldState.Thing(ObjectPose.of(part));
            addFixed(thing, part, world);
            parts(robot, Motor.class).filter(motor -> motor.getWheelNames().contains(part.getName())).findFirst()
                .ifPresent(motor -> thing.more.put("motor", motor.getName()));
            return thing;
        }).collect(Collectors.toList());
    }

    /** Extends a robot's path; panels do the same with the poses they get. */
    private void extendPath(Snapshot.RobotState robot) {
        List<double[]> path = paths.computeIfAbsent(robot.name, name -> new ArrayList<>());
        double[] last = path.isEmpty() ? null : path.get(path.size() - 1);
        if (last == null || Math.hypot(last[0] - robot.pose.x, last[1] - robot.pose.z) > PATH_STEP) {
            path.add(new double[] {JsonNumbers.rounded(robot.pose.x, FINE), JsonNumbers.rounded(robot.pose.z, FINE)});
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
        probe.names = of.names(robot.getTruth());
    }

    private static List<float[]> fan(BeamFan of) {
        List<float[]> directions = new ArrayList<>(of.size());
        for (int i = 0; i < of.size(); i++) {
            directions.add(Arrays.copyOfRange(of.directions, 3 * i, 3 * i + 3));
        }
        return directions;
    }

    private WorldState.Probe probe(Robot robot, Sensor<?> sensor, Reading reading) {
        WorldState.Probe probe = new WorldState.Probe();
        probe.pose = robot.getPose().times(sensor.getMount());
        probe.words = texts.of(sensor.getName(), reading);
        probe.numbers = reading == null
            ? new ArrayList<>(Collections.nCopies(sensor.names(robot.getTruth()).size(), null))
            : JsonNumbers.numbers(reading.numbers());
        probe.picture = reading == null || reading.picture() == null ? null : SmallPicture.of(reading.picture());
        if (sensor.takesPictures()) {      // a camera's value and hits are too many; the picture shows them
            return probe;
        }
        LidarScan scan = reading.scan();
        if (scan == null) {
            probe.value = Optional.ofNullable(reading.value());
        } else {
            probe.ranges = new ScanRanges(scan.ranges());
        }
        if (reading.hits() != null) {
            probe.hit = reading.hits().stream().findFirst().map(hit -> JsonNumbers.point(hit, MILLIMETRES));
        }
        return probe;
    }
}
