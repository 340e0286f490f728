// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Chessboard;
import org.SEAR.POJOs.ColorSensor;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.LineSensor;
import org.SEAR.POJOs.Marker;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.Picture;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Wheel;
import org.SEAR.protocol.lidar.LidarModel;

/** Creates random legal projects: any class, any legal value, odd names. The same seed gives the same project. */
public final class RandomProjects {
    private static final String[] LETTERS = {"a", "B", " ", "_", "1", ".", "\u00e4", "\u00df", "\u6728", "\ud83e\udd16",
        "'", "&", "#", "]]", "(", "%20"};
    private final Random random;
    private int counter;

    /** @param seed of all choices */
    public RandomProjects(long seed) {
        random = new Random(seed);
    }

    /** Creates a project in the present folder. */
    public void create() {
        int objects = random.nextInt(4);
        for (int i = 0; i < objects; i++) {
            shape(true);
        }
        int robots = random.nextInt(3);
        for (int i = 0; i < robots; i++) {
            robot();
        }
    }

    private String name() {
        StringBuilder name = new StringBuilder("n" + counter++);
        int letters = random.nextInt(12);
        for (int i = 0; i < letters; i++) {
            name.append(LETTERS[random.nextInt(LETTERS.length)]);
        }
        return name.append('z').toString();
    }

    private double number(double min, double max) {
        switch (random.nextInt(6)) {
            case 0:
                return min;
            case 1:
                return max;
            case 2:
                return Math.max(min, Math.min(max, random.nextInt(10)));
            case 3:
                return Math.max(min, Math.min(max, random.nextGaussian() * 1e-7));
            default:
                return min + (max - min) * random.nextDouble();
        }
    }

    private double size() {
        return number(0.0001, 100000);
    }

    private void place(SearObject object) {
        if (random.nextBoolean()) {
            object.move(number(-100000, 100000), number(-100000, 100000), number(-100000, 100000));
            object.rotate(number(-360, 360), number(-360, 360), number(-36000, 36000));
        }
    }

    private Shape shape(boolean environment) {
        Shape shape;
        double mass = random.nextInt(4) == 0 ? 0 : number(1e-6, 1e6);
        switch (random.nextInt(environment ? 9 : 8)) {
            case 0:
                shape = new Box(name(), size(), size(), size(), mass);
                break;
            case 1:
                shape = new Cylinder(name(), size(), size(), mass, "./textures/roomba.jpg");
                break;
            case 2:
                shape = new Cone(name(), size(), size(), mass);
                break;
            case 3:
                shape = new Sphere(name(), size(), mass);
                break;
            case 4:
                shape = new Model(name(), "models/Tree/Tree.mesh.xml", mass);
                break;
            case 5:
                shape = new Marker(name(), random.nextBoolean() ? "APRILTAG_36h11" : "DICT_6X6_250",
                    random.nextInt(250), number(0.0001, 100));
                break;
            case 6:
                shape = new Chessboard(name(), 3 + random.nextInt(58), 3 + random.nextInt(58), number(0.0001, 100));
                break;
            case 7:
                shape = new Picture(name(), size(), size(), "./textures/roomba.jpg");
                break;
            default:
                shape = new Floor(name(), size(), size(), random.nextBoolean());
                break;
        }
        place(shape);
        shape.scale(number(0.0001, 10000), number(0.0001, 10000), number(0.0001, 10000));
        shape.setVisibleToSensors(random.nextBoolean());
        return shape;
    }

    private void robot() {
        SEARrobot robot = new SEARrobot(name());
        place(robot);
        if (random.nextBoolean()) {
            Dynamics dynamics = new Dynamics(name(), number(0.001, 1e6), number(0, 1e6), number(0, 1e6), number(0, 1e6),
                number(0, 1e9), number(0, 100), 0, 0.1, 0, 0, number(-360, 360), 180);
            dynamics.setPorts("/dev/uart" + counter, "/dev/user" + counter);
            robot.addComponent(dynamics);
        }
        int parts = random.nextInt(4);
        for (int i = 0; i < parts; i++) {
            robot.addComponent(random.nextBoolean() ? shape(false) : sensor());
        }
        for (int i = random.nextInt(3); i > 0; i--) {
            Wheel wheel = new Wheel(name(), number(0.0001, 100), number(0.0001, 100), random.nextInt(2));
            place(wheel);
            robot.addWheel(wheel);
        }
        if (random.nextBoolean()) {
            robot.addComponent(servo(robot));
        }
    }

    /** Makes a servo that turns some of the robot's parts and a light. */
    private Servo servo(SEARrobot robot) {
        Led led = new Led(name(), random.nextBoolean() ? null
            : String.format("#%06x", random.nextInt(1 << 24)), 0, 0, 0);
        led.setSize(number(0.001, 1));
        place(led);
        Servo servo = new Servo(name());
        place(servo);
        servo.setRange(number(-360, -1), number(0, 360));
        servo.setSpeed(number(0.1, 36000));
        servo.setStallTorque(number(1e-6, 1e6));
        robot.getComponents().stream().filter(part -> Servo.canTurn(part) && random.nextBoolean())
            .forEach(servo::mount);
        robot.addComponent(led);
        if (random.nextBoolean()) {
            servo.mount(led);
        }
        return servo;
    }

    private SensorObject sensor() {
        SensorObject sensor = anySensor();
        place(sensor);
        if (random.nextBoolean()) {
            sensor.setNoise(new Noise(number(0, 1e6), number(-1e6, 1e6), number(0, 1e6), number(0, 1e6),
                random.nextDouble()));
        }
        return sensor;
    }

    private Camera anyCamera() {
        Camera camera = new Camera(name());
        camera.setKind(new String[] {Camera.COLOR, Camera.DEPTH, Camera.INFRARED}[random.nextInt(3)]);
        camera.setSize(1 + random.nextInt(1000), 1 + random.nextInt(1000));
        camera.setFieldOfView(number(0.1, 170));
        camera.setRate(number(0.001, 60));
        camera.setRange(number(0.001, 1), number(2, 1e6));
        camera.setExposure(number(0.001, 1000));
        camera.setShotNoise(number(1, 1e9), number(0, 1e6));
        camera.setDepthNoise(number(0, 10));
        camera.setNetd(number(0, 100));
        camera.setSeesOwnRobot(random.nextBoolean());
        return camera;
    }

    private SensorObject anySensor() {
        switch (random.nextInt(9)) {
            case 8:
                if (random.nextInt(3) == 0) {
                    return anyCamera();
                }
                return random.nextInt(3) == 0 ? new Bumper(name()) : random.nextBoolean() ? new LineSensor(name())
                    : new ColorSensor(name());
            case 0:
                return new Accelerometer(name(), number(0.01, 10000));
            case 1:
                return new Gyroscope(name(), number(0.01, 10000));
            case 2:
                return random.nextBoolean() ? new IMU(name(), "/dev/i" + counter, "/dev/j" + counter)
                    : new Compass(name(), random.nextBoolean());
            case 3:
                return new Odometer(name());
            case 4:
                return new GPS(name(), number(-90, 90), number(-12000, 100000), number(-180, 180), "/dev/g" + counter,
                    "/dev/h" + counter);
            case 5:
                LIDAR lidar = new LIDAR(name(), number(0.01, 10000), 360, number(0.01, 360));
                lidar.LMS(random.nextInt(2));
                if (random.nextBoolean()) {
                    lidar.setModel(LidarModel.values()[random.nextInt(LidarModel.values().length)].getName());
                }
                return lidar;
            case 6:
                List<String> beams = new BeamLibrary(ProjectFolder.present()).names();
                return new Distance(name(), beams.get(random.nextInt(beams.size())));
            default:
                return new Distance(name(), cones());
        }
    }

    private List<BeamCone> cones() {
        List<BeamCone> cones = new ArrayList<>();
        for (int i = random.nextInt(5); i >= 0; i--) {
            cones.add(new BeamCone(number(0, 90), number(0.001, 10000), String.format("#%06x", random.nextInt(1 << 24)),
                1 + random.nextInt(360), number(-180, 180), number(-90, 90)));
        }
        return cones;
    }
}
