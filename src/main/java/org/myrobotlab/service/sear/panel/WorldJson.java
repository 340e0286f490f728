package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.devices.PinState;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.Robot;
import org.SEAR.robot.Stability;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Snapshot;
import org.myrobotlab.service.sear.readings.EulerAngles;

/**
 * The state of the world as panels draw it, as maps, lists and numbers for JSON. Metres and degrees; poses are [x, y, z, rx, ry, rz], rounded to
 * tenths of millimetres and thousandths of degrees.
 *
 * <pre>
 * {"time": 1.5, "step": 90,
 *  "objects": [{"name": "Box1", "type": "Box", "corners": [[x, y, z], ..] (enough for its outline from any side, in its own frame),
 *               "look": "6f1e.." (see {@link Looks}; empty if it is not told), "picture": "textures/cardboard.png" or null,
 *               "color": "#c49a6c", "colored": false (whether the colour is its own, not its kind's),
 *               "pose": [..]},
 *              {"name": "Tree1", "type": "Model", "terrain": false, ..},
 *              {"name": "Land", "type": "Terrain", "ground": "1f-2e" (its stamp: see {@link TerrainMap}), ..}],
 *  "robots": [{"name": "myRoomba", "pose": [..], "start": [..] (its pose after a reset), "written": [..] (what its file
 *               says of that), "speed": 0.2, "turnRate": 0, "radius": 0.17, "path": [[x, z], ..],
 *              "devices": [{"name", "on" (whether it has power), "status" (what it is doing),
 *                           "pins": [{"pin", "wired", "mode", "value"}] (texts; only of a board)}],
 *              "parts": [{"name", "type", "corners", "look", "picture", "color", "colored", "pose" (in the body)}], "wheels": [pose, ..],
 *              "turned": [pose, ..] (of the other parts, if the robot has servos),
 *              "leds": [{"name", "color", "size", "pose" (in the body)}], "lights": [0.5, ..] (how bright each is; both if the robot has leds),
 *              "turnedLeds": [pose, ..] (of the leds, if the robot has servos, too),
 *              "balance": {"centre": [x, y, z] (of mass, in the body), "support": [[x, y, z], ..] (the corners of what it stands on),
 *                          "critical": false (whether it tips over easily), "words": "tips over .."}}],
 *  "sensors": [{"name": "Ping1", "type": "Distance", "robot": "myRoomba", "pose": [..],
 *               "value": 1.25 (what scripts get), "words": "1.250 m", "unit": "m",
 *               "numbers": [1.25] (as records keep them; null for none), "names": [""] (of the numbers, behind the sensor's),
 *               "hit": [x, y, z] or null (only if beams meet something at a place), "cones": [{"halfAngle", "range", "yaw"}]},
 *              {"name": "myLidar", .., "spread": 180, "resolution": 1, "ranges": [.., null, ..] (in the place of the value)},
 *              {"name": "eye", .., "picture": "data:image/png;base64,.."}]}
 * </pre>
 *
 * <p>{@link WorldFeed} adds what only a running simulation has.
 */
public final class WorldJson {
    /** The lists of a state, each of maps. */
    static final List<String> LISTS = Collections.unmodifiableList(Arrays.asList("objects", "robots", "sensors"));
    private static final double FINE = 1e4;
    /** A centimetre on Earth has seven digits of a degree. */
    private static final double FINEST = 1e8;
    private static final double MILLIMETRES = 1e3;
    private static final double ANGLE = 1e3;
    private static final double PATH_STEP = 0.02;
    private static final int LONGEST_PATH = 500;

    private final Map<String, List<double[]>> paths = new LinkedHashMap<>();
    private final Looks looks;
    private double lastTime;

    WorldJson(Looks looks) {
        this.looks = looks;
    }

    /** The world without what only a running simulation has; simulation thread. */
    public synchronized Map<String, Object> of(Simulation world) {
        Map<String, Object> state = moving(world);
        looks.begin(world);
        addFixed(list(state, "objects"), world.getProject().getEnvironment(), world);
        List<Map<String, Object>> robots = list(state, "robots");
        List<Map<String, Object>> sensors = list(state, "sensors");
        int sensor = 0;
        for (int i = 0; i < robots.size(); i++) {
            Robot robot = world.getRobots().get(i);
            Map<String, Object> map = robots.get(i);
            map.put("name", robot.getObject().getName());
            map.put("radius", rounded(robot.getHardware().getBodyRadius(), FINE));
            map.put("path", new ArrayList<>(paths.get(robot.getObject().getName())));
            map.put("parts", parts(world, robot));
            if (map.containsKey("lights")) {
                map.put("leds", leds(robot));
            }
            map.put("balance", balance(robot.getStability()));
            for (Sensor<?> one : robot.getSensors()) {
                addFixed(sensors.get(sensor++), robot, one, world);
            }
        }
        return state;
    }

    /** What can change from step to step, in the same places as in the whole; simulation thread. */
    synchronized Map<String, Object> moving(Simulation world) {
        Snapshot snapshot = world.snapshot();
        if (snapshot.time < lastTime) {
            paths.clear();
        }
        lastTime = snapshot.time;
        Map<String, Object> state = new LinkedHashMap<>();
        state.put("time", snapshot.time);
        state.put("step", snapshot.step);
        List<Map<String, Object>> objects = new ArrayList<>();
        snapshot.environment.forEach(pose -> objects.add(posed(pose)));
        state.put("objects", objects);
        state.put("robots", robots(world, snapshot));
        state.put("sensors", sensors(world));
        return state;
    }

    /** A world without anything in it. */
    static Map<String, Object> empty() {
        Map<String, Object> state = new LinkedHashMap<>();
        LISTS.forEach(list -> state.put(list, new ArrayList<>()));
        return state;
    }

    @SuppressWarnings("unchecked")
    static List<Map<String, Object>> list(Map<String, Object> state, String name) {
        return (List<Map<String, Object>>) state.get(name);
    }

    private static Map<String, Object> posed(Pose pose) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("pose", numbers(pose));
        return map;
    }

    private void addFixed(List<Map<String, Object>> maps, List<? extends SearObject> objects, Simulation world) {
        for (int i = 0; i < maps.size(); i++) {
            addFixed(maps.get(i), objects.get(i), world);
        }
    }

    private void addFixed(Map<String, Object> map, SearObject object, Simulation world) {
        map.put("name", object.getName());
        map.put("type", object.getClass().getSimpleName());
        map.put("corners", corners(world.getOutline(object)));
        if (object instanceof Shape) {
            looks.add(map, (Shape) object, world);
            map.put("color", ((Shape) object).getColor());
            map.put("colored", ((Shape) object).hasColor());
        }
        if (object instanceof Model) {
            map.put("terrain", ((Model) object).isTerrain());
        }
        if (object instanceof Terrain) {
            map.put("ground", ground(world.getProject()));
        }
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

    private List<Object> robots(Simulation world, Snapshot snapshot) {
        List<Object> list = new ArrayList<>();
        for (Snapshot.RobotState robot : snapshot.robots) {
            Map<String, Object> map = posed(robot.pose);
            addStart(map, world.getRobots().get(list.size()));
            map.put("speed", rounded(robot.speed, FINE));
            map.put("turnRate", rounded(robot.turnRate, FINE));
            map.put("devices", devices(robot));
            map.put("wheels", wheels(robot.wheels));
            if (!robot.parts.isEmpty()) {
                map.put("turned", turned(world.getRobots().get(list.size()).getObject(), robot.parts, Shape.class));
            }
            if (!robot.lights.isEmpty()) {
                map.put("lights", robot.lights);
                if (!robot.parts.isEmpty()) {
                    map.put("turnedLeds", turned(world.getRobots().get(list.size()).getObject(), robot.parts, Led.class));
                }
            }
            extendPath(robot);
            list.add(map);
        }
        return list;
    }

    private static void addStart(Map<String, Object> map, Robot robot) {
        SEARrobot written = robot.getWritten();
        map.put("start", numbers(robot.getStart()));
        map.put("written", new double[] {written.getX(), written.getY(), written.getZ(), written.getRx(), written.getRy(), written.getRz()});
    }

    /** Their poses in the body, as they have turned, in the order of the wheels among the parts. */
    private static double[][] wheels(List<Pose> poses) {
        double[][] all = new double[poses.size()][];
        for (int i = 0; i < all.length; i++) {
            all[i] = numbers(poses.get(i));
        }
        return all;
    }

    /** The poses in the body of the parts of one kind, as servos have turned them. */
    private static double[][] turned(SEARrobot robot, List<Pose> poses, Class<? extends SearObject> kind) {
        List<double[]> list = new ArrayList<>();
        for (int i = 0; i < poses.size(); i++) {
            if (kind.isInstance(robot.getComponents().get(i))) {
                list.add(numbers(poses.get(i)));
            }
        }
        return list.toArray(new double[0][]);
    }

    private static List<Object> pins(List<PinState> states) {
        List<Object> list = new ArrayList<>();
        for (PinState state : states) {
            Map<String, Object> map = new LinkedHashMap<>();
            map.put("pin", state.pin);
            map.put("wired", state.wired);
            map.put("mode", state.mode);
            map.put("value", state.value);
            list.add(map);
        }
        return list;
    }

    private static List<Object> devices(Snapshot.RobotState robot) {
        List<Object> list = new ArrayList<>();
        for (Snapshot.DeviceState device : robot.devices) {
            Map<String, Object> map = new LinkedHashMap<>();
            map.put("name", device.name);
            map.put("on", device.powered);
            map.put("status", device.status);
            if (!device.pins.isEmpty()) {
                map.put("pins", pins(device.pins));
            }
            list.add(map);
        }
        return list;
    }

    private List<Object> parts(Simulation world, Robot robot) {
        List<SearObject> visible = new ArrayList<>();
        robot.getObject().getComponents().stream().filter(part -> part instanceof Shape).forEach(visible::add);
        visible.addAll(robot.getObject().getWheels());
        List<Object> list = new ArrayList<>();
        for (SearObject part : visible) {
            Map<String, Object> map = posed(ObjectPose.of(part));
            addFixed(map, part, world);
            list.add(map);
        }
        return list;
    }

    private static List<Object> leds(Robot robot) {
        List<Object> list = new ArrayList<>();
        for (SearObject part : robot.getObject().getComponents()) {
            if (part instanceof Led) {
                Map<String, Object> map = posed(ObjectPose.of(part));
                map.put("name", part.getName());
                map.put("color", ((Led) part).getColor());
                map.put("size", ((Led) part).getSize());
                list.add(map);
            }
        }
        return list;
    }

    private static Map<String, Object> balance(Stability stability) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("centre", point(stability.getCentre(), FINE));
        map.put("support", corners(stability.getSupport()));
        map.put("critical", stability.isCritical());
        map.put("words", stability.getWords());
        return map;
    }

    /** Panels do the same with the poses that they get. */
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

    private static List<Object> sensors(Simulation world) {
        List<Object> list = new ArrayList<>();
        for (Robot robot : world.getRobots()) {
            for (Sensor<?> sensor : robot.getSensors()) {
                Map<String, Object> map = posed(robot.getPose().times(sensor.getMount()));
                addReading(map, world.read(sensor.getName()), world.getUnit(sensor.getName()));
                list.add(map);
            }
        }
        return list;
    }

    private static void addFixed(Map<String, Object> map, Robot robot, Sensor<?> of, Simulation world) {
        SearObject sensor = of.getParameters();
        map.put("name", sensor.getFullName());
        map.put("type", sensor.getClass().getSimpleName());
        map.put("robot", robot.getObject().getName());
        map.put("unit", world.getUnit(of.getName()));
        map.put("names", world.read(of.getName()).names());
        if (sensor instanceof Distance) {
            List<Object> cones = new ArrayList<>();
            for (BeamCone cone : ((Distance) sensor).getCones()) {
                Map<String, Object> one = new LinkedHashMap<>();
                one.put("halfAngle", cone.getHalfAngle());
                one.put("range", cone.getRange());
                one.put("yaw", cone.getYaw());
                cones.add(one);
            }
            map.put("cones", cones);
        }
    }

    private static void addReading(Map<String, Object> map, Reading reading, String unit) {
        LidarScan scan = reading.scan();
        if (scan == null) {
            map.put("value", reading.value());
        } else {
            map.put("spread", scan.getSpread());
            map.put("resolution", scan.getResolution());
            map.put("ranges", numbers(scan.ranges(), FINE));
        }
        if (reading.hits() != null) {
            map.put("hit", reading.hits().isEmpty() ? null : point(reading.hits().get(0), MILLIMETRES));
        }
        map.put("words", reading.words(unit));
        map.put("numbers", numbers(reading.numbers(), FINEST));
        if (reading.picture() != null) {
            map.put("picture", SmallPicture.of(reading.picture()));
        }
    }

    /** Null for what is no number, or infinite. */
    private static List<Double> numbers(double[] exact, double per) {
        List<Double> numbers = new ArrayList<>(exact.length);
        for (double number : exact) {
            numbers.add(Double.isNaN(number) || Double.isInfinite(number) ? null : Double.valueOf(rounded(number, per)));
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
