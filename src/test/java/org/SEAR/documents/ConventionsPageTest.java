// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.ToDoubleFunction;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.ImuReading;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.sear.readings.EulerAngles;

/** Formulas and numbers of docs/conventions.md are those of the code. */
public class ConventionsPageTest {
    private static final Path PAGE = Path.of(System.getProperty("sear.root", "."), "docs/conventions.md");
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?");
    private static final Pattern NAME = Pattern.compile("`(\\w+)`");
    /** Tolerance of numbers with three or four decimals. */
    private static final double THREE = 6e-4;
    private static final double FOUR = 6e-5;
    /** Rows: axes of another frame in those of SEAR's. */
    private static final double[][] SAME = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    private static final double[][] REP_103 = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    private static final double[][] NED = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    private static final double[][] FRD = {{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};
    /** The example of the page. */
    private static final double[] PLACE = {2, 0.5, 3};
    private static final double[] TURN = {10, 30, 20};
    private static final double[][] POINT = {{3}, {0.2}, {5}};

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Returns the cells of the row that begins with a cell. */
    private static String[] row(String first) throws IOException {
        List<String> rows = Files.readString(PAGE).lines().filter(line -> line.startsWith("| " + first + " |"))
            .collect(Collectors.toList());
        assertEquals("rows that begin with " + first, 1, rows.size());
        return Arrays.stream(rows.get(0).split("\\|")).skip(1).map(String::trim).toArray(String[]::new);
    }

    private static double[] numbers(String cell) {
        return NUMBER.matcher(cell).results().map(MatchResult::group).mapToDouble(Double::parseDouble).toArray();
    }

    private static void assertCell(String first, int column, double tolerance, double... expected) throws IOException {
        String cell = row(first)[column];
        assertArrayEquals(first + ": " + cell + ", expected " + Arrays.toString(expected), expected,
            numbers(cell), tolerance);
    }

    private static double[][] product(double[][] a, double[][] b) {
        double[][] c = new double[a.length][b[0].length];
        for (int i = 0; i < c.length; i++) {
            for (int j = 0; j < c[i].length; j++) {
                for (int k = 0; k < b.length; k++) {
                    c[i][j] += a[i][k] * b[k][j];
                }
            }
        }
        return c;
    }

    private static double[][] transposed(double[][] a) {
        double[][] b = new double[a[0].length][a.length];
        for (int i = 0; i < b.length; i++) {
            for (int j = 0; j < a.length; j++) {
                b[i][j] = a[j][i];
            }
        }
        return b;
    }

    private static double[][] matrix(Pose of) {
        Rotation r = new Rotation().set(of);
        return new double[][] {{r.xx, r.xy, r.xz}, {r.yx, r.yy, r.yz}, {r.zx, r.zy, r.zz}};
    }

    private static double[][] matrix(double rx, double ry, double rz) {
        return matrix(Pose.ofDegrees(0, 0, 0, rx, ry, rz));
    }

    /** Returns the value of a formula such as {@code sx sy - cx cy sz}. */
    private static double value(String formula, Map<String, Double> symbols) {
        double sum = 0;
        double product = 1;
        for (String token : (formula + " +").split(" ")) {
            if (token.equals("+") || token.equals("-")) {
                sum += product;
                product = token.equals("-") ? -1 : 1;
            } else {
                product *= symbols.get(token.replace("-", "")) * (token.startsWith("-") ? -1 : 1);
            }
        }
        return sum;
    }

    @Test
    public void theFormulasAreThoseOfRotate() throws IOException {
        for (double[] turn : new double[][] {TURN, {-100, 170, 80}, {0, 90, 0}, {45, 0, -45}}) {
            Map<String, Double> symbols = new TreeMap<>();
            for (int axis = 0; axis < 3; axis++) {
                symbols.put("s" + "xyz".charAt(axis), Math.sin(Math.toRadians(turn[axis])));
                symbols.put("c" + "xyz".charAt(axis), Math.cos(Math.toRadians(turn[axis])));
            }
            double[][] matrix = matrix(turn[0], turn[1], turn[2]);
            double[][] about = product(matrix(0, turn[1], 0), product(matrix(0, 0, turn[2]), matrix(turn[0], 0, 0)));
            for (int i = 0; i < 3; i++) {
                String[] cells = row("xyz".charAt(i) + " of the parent");
                double[] page = Arrays.stream(cells).skip(1).mapToDouble(cell -> value(cell, symbols)).toArray();
                assertArrayEquals(String.join(" | ", cells), matrix[i], page, 1e-12);
                assertArrayEquals("Ry Rz Rx", matrix[i], about[i], 1e-12);
            }
        }
    }

    /** Returns yaw, pitch and roll of a matrix, degrees, the order of ROS and of MRPT. */
    private static double[] yawPitchRoll(double[][] r) {
        return new double[] {Math.toDegrees(Math.atan2(r[1][0], r[0][0])), Math.toDegrees(Math.asin(-r[2][0])),
            Math.toDegrees(Math.atan2(r[2][1], r[2][2]))};
    }

    private static double[] quaternion(double[][] r) {
        double w = Math.sqrt(1 + r[0][0] + r[1][1] + r[2][2]) / 2;
        return new double[] {(r[2][1] - r[1][2]) / (4 * w), (r[0][2] - r[2][0]) / (4 * w),
            (r[1][0] - r[0][1]) / (4 * w), w};
    }

    private static void assertConvention(int column, double[][] world, double[][] body, double[] rotation)
        throws IOException {
        double[][] own = matrix(TURN[0], TURN[1], TURN[2]);
        double[][] r = product(world, product(own, transposed(body)));
        double[][] place = {{PLACE[0]}, {PLACE[1]}, {PLACE[2]}};
        double[][] offset = {{POINT[0][0] - PLACE[0]}, {POINT[1][0] - PLACE[1]}, {POINT[2][0] - PLACE[2]}};
        assertCell("position", column, 0, transposed(product(world, place))[0]);
        assertCell("rotation", column, THREE, rotation == null ? yawPitchRoll(r) : rotation);
        assertCell("R, first row", column, THREE, r[0]);
        assertCell("R, second row", column, THREE, r[1]);
        assertCell("R, third row", column, THREE, r[2]);
        assertCell("quaternion x, y, z, w", column, THREE, quaternion(r));
        assertCell("point in the world", column, 0, transposed(product(world, POINT))[0]);
        assertCell("point in the object's frame", column, THREE,
            transposed(product(body, product(transposed(own), offset)))[0]);
    }

    @Test
    public void theExampleIsTheSameInEachConvention() throws IOException {
        assertConvention(1, SAME, SAME, TURN);
        assertConvention(2, REP_103, REP_103, null);
        assertConvention(3, NED, FRD, null);
        Pose pose = Pose.ofDegrees(PLACE[0], PLACE[1], PLACE[2], TURN[0], TURN[1], TURN[2]);
        assertCell("quaternion x, y, z, w", 1, THREE, pose.qx, pose.qy, pose.qz, pose.qw);
        assertCell("quaternion x, y, z, w", 2, THREE, pose.qz, pose.qx, pose.qy, pose.qw);
        assertArrayEquals(TURN, EulerAngles.degrees(pose), 1e-9);
        assertArrayEquals(new double[] {30, 10, 0},
            yawPitchRoll(product(REP_103, product(matrix(10, 30, 0), transposed(REP_103)))), 1e-9);
        assertArrayEquals(new double[] {30, 0, 20},
            yawPitchRoll(product(REP_103, product(matrix(0, 30, 20), transposed(REP_103)))), 1e-9);
    }

    @Test
    public void theExampleIsTheSameInOpencv() throws IOException {
        Camera camera = new Camera("camera");
        double[] place = numbers(row("point in the object's frame")[1]);
        double[] point = {-place[0], -place[1], place[2]};
        assertCell("point in the camera's frame", 2, 0, point);
        assertCell("fx = fy", 2, THREE, camera.getFocalLength());
        assertCell("cx, cy", 2, 0, camera.getLens().column(0, 0), camera.getLens().row(0, 0));
        Pose pose = Pose.ofDegrees(PLACE[0], PLACE[1], PLACE[2], TURN[0], TURN[1], TURN[2]);
        double[] exact = pose.rotateBack(POINT[0][0] - PLACE[0], POINT[1][0] - PLACE[1], POINT[2][0] - PLACE[2]);
        assertCell("pixel: cx + fx x / z, cy + fy y / z", 2, THREE, camera.getLens()
            .column(-exact[0] / exact[2], -exact[1] / exact[2]),
            camera.getLens().row(-exact[0] / exact[2], -exact[1] / exact[2]));
    }

    /** An IMU at the example's rotation: 30 degrees by its robot, the others by its mounting. */
    @Test
    public void anImuReadsTheAnglesOfNed() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = Robots.create2("robot");
        robot.placeAt(0, 0, 60);
        IMU imu = new IMU("imu");
        imu.rotate(TURN[0], 0, TURN[2]);
        robot.addComponent(imu);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        ImuReading reading = (ImuReading) simulation.read("imu");
        assertCell("rotation", 3, THREE, reading.getYaw(), reading.getPitch(), reading.getRoll());
    }

    private static double[] pose(Simulation simulation, String name) {
        Pose pose = simulation.getPose(name);
        return DoubleStream.concat(DoubleStream.of(pose.x, pose.y, pose.z), Arrays.stream(EulerAngles.degrees(pose)))
            .toArray();
    }

    @Test
    public void aServosPartsTurn() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = Robots.create2("robot");
        robot.placeAt(0, 0, 90);
        Servo neck = new Servo("neck", 0, 0.1, 0.1);
        SearObject horn = new Led("horn", "red", 0, 0.1, 0.1);
        SearObject ping = new Distance("ping", "PING)))", 0, 0.12, 0.15, 0, 0, 0);
        neck.mount(horn);
        neck.mount(ping);
        for (SearObject part : List.of(neck, horn, ping)) {
            robot.addComponent(part);
        }
        Simulation simulation = Worlds.start(project);
        for (int column = 1; column <= 2; column++) {
            Worlds.run(simulation, 1);
            for (String part : List.of("neck", "horn", "ping")) {
                assertCell(part, column, FOUR, pose(simulation, part));
            }
            simulation.getServo("neck").setAngle(40);
        }
    }

    private static double[] distinct(Collection<Wheel> wheels, ToDoubleFunction<Wheel> number) {
        return wheels.stream().mapToDouble(number).distinct().boxed().sorted((a, b) -> Double.compare(b, a))
            .mapToDouble(one -> one).toArray();
    }

    /** Returns the distance between the extreme values, none without one. */
    private static double[] extent(double[] values) {
        return values.length < 2 ? new double[0] : new double[] {values[0] - values[values.length - 1]};
    }

    private static List<Wheel> wheels(SEARrobot robot, int type) {
        return robot.getWheels().stream().filter(wheel -> wheel.getType() == type).collect(Collectors.toList());
    }

    /** Returns what the page states about idle and steered wheels. */
    private static double[] others(SEARrobot robot) {
        List<Wheel> idle = wheels(robot, Wheel.IDLER);
        List<Wheel> trailing = idle.stream().filter(wheel -> wheel.getTrail() > 0).collect(Collectors.toList());
        List<Wheel> steered = wheels(robot, Wheel.FREE);
        return Stream.of(distinct(idle, Wheel::getRadius), distinct(idle, SearObject::getZ),
            distinct(trailing, Wheel::getTrail),
            distinct(steered, SearObject::getZ), distinct(steered, Wheel::getSteering))
            .flatMapToDouble(Arrays::stream).toArray();
    }

    @Test
    public void theReadyRobotsHaveTheseDimensions() throws Exception {
        new Floor("floor", 40, 40);
        Map<String, SEARrobot> robots = new TreeMap<>();
        for (Method method : Robots.class.getMethods()) {
            if (method.getReturnType() == SEARrobot.class && method.getParameterCount() == 1) {
                SEARrobot robot = (SEARrobot) method.invoke(null, method.getName() + "Robot");
                robot.placeAt(2 * robots.size() - 7, 0, 90);
                robots.put(method.getName(), robot);
            }
        }
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 2);
        List<String> listed = new ArrayList<>();
        List<String> rows = Files.readString(PAGE).split("\\| origin above ground at rest \\|\n")[1].lines().skip(1)
            .collect(Collectors.toList());
        for (String line : rows) {
            String[] cells = line.split("\\|");
            for (MatchResult name : NAME.matcher(cells[1]).results().collect(Collectors.toList())) {
                SEARrobot robot = robots.get(name.group(1));
                List<Wheel> driven = wheels(robot, Wheel.DRIVEN);
                List<Wheel> gripping = robot.getWheels().stream().filter(wheel -> wheel.getType() != Wheel.IDLER)
                    .collect(Collectors.toList());
                double[][] expected = {distinct(gripping, Wheel::getRadius),
                    extent(distinct(gripping, SearObject::getX)),
                    extent(distinct(gripping, SearObject::getZ)), distinct(driven, SearObject::getZ), others(robot),
                    {simulation.getPose(robot.getName()).y}};
                for (int i = 0; i < expected.length; i++) {
                    assertArrayEquals(line + ", expected " + Arrays.toString(expected[i]), expected[i],
                        numbers(cells[i + 2]), FOUR);
                }
                listed.add(name.group(1));
            }
        }
        assertEquals(robots.keySet(), new TreeSet<>(listed));
    }
}
