// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Chessboard;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Marker;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.Picture;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Wheel;

/** Small projects for the window's tests. */
final class ViewProjects {
    private ViewProjects() {
    }

    /**
     * Makes a robot before a marker, a chessboard, a picture and a plate that shows its back, so near that they fill
     * much of its view.
     */
    static Path plates() throws IOException {
        Path folder = Files.createTempDirectory("view").resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        new Floor("floor", 16, 16);
        new Marker("marker", "DICT_4X4_50", 7, 0.6, 0.9, 0.45, 0.6, 0, 20, 10);
        new Chessboard("board", 6, 5, 0.1, 0.1, 0.4, 0.6);
        new Picture("picture", 0.9, 0.5, null, -0.8, 0.4, 0.6, 0, -20, 0);
        new Marker("back", "APRILTAG_36h11", 3, 0.3, 0.7, 0.3, -0.3, 0, 180, 0);
        SEARrobot robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.2, 0.2, 0.1, 4));
        return folder;
    }

    /** Makes a room of 20 boxes with a robot that has every sensor, read from a folder. */
    static Path room() throws IOException {
        Path folder = Files.createTempDirectory("view").resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        Path assets = Files.createDirectories(folder.resolve("assets"));
        paint(assets.resolve("red.png"), Color.RED);
        paint(assets.resolve("green.png"), new Color(0, 160, 0));
        paint(assets.resolve("blue.png"), Color.BLUE);
        paint(assets.resolve("yellow.png"), new Color(240, 220, 0));
        paint(assets.resolve("grey.png"), new Color(150, 150, 150));
        Files.writeString(assets.resolve("wedge.obj"), "v -0.3 0 -0.3\nv 0.3 0 -0.3\nv 0 0 0.4\nv 0 0.7 0\nf 1 2 3\nf "
            + "1 4 2\nf 2 4 3\nf 3 4 1\n");
        Floor floor = new Floor("Floor", 16, 16);
        floor.setImage("grey.png");
        floor.setImageSize(0.5);
        box("RedBox", "red.png", 2, 2.2);
        box("GreenBox", "green.png", 0, 2.6);
        box("BlueBox", "blue.png", -2, 2.2);
        Random random = new Random(20);
        for (int i = 0; i < 17; i++) {
            double around = Math.PI * (0.3 + 1.4 * i / 17);
            box("Box" + i, "grey.png", Math.sin(around) * (3 + random.nextDouble()),
                Math.cos(around) * (3 + random.nextDouble()));
        }
        new Cylinder("Drum", 0.25, 0.7, 0, "yellow.png").move(1, 0.35, 3.4);
        new Cone("Spike", 0.25, 0.7, 0, "red.png").move(-1, 0.35, 3.4);
        Sphere egg = new Sphere("Egg", 0.25, 0, "green.png");
        egg.move(2, 0.35, 3.4);
        egg.scale(0.8, 1.4, 0.8);
        Box plain = new Box("Plain", 0.2, 0.2, 0.2, 0);
        plain.setColor("orange");
        plain.move(1, 0.1, 1.5);
        new Sphere("Ball", 0.1).move(-1, 0.1, 1.5);
        Model wedge = new Model("Wedge", "wedge.obj");
        wedge.setImage("blue.png");
        wedge.move(3.2, 0, 0.5);
        robot();
        return folder;
    }

    private static void box(String name, String image, double x, double z) {
        Box box = new Box(name, 0.5, 0.5, 0.5, 0);
        box.setImage(image);
        box.move(x, 0.25, z);
    }

    private static void robot() {
        SEARrobot robot = new SEARrobot("Roomba1");
        robot.addComponent(new Cylinder("Body", 0.17, 0.07, 2.5));
        wheel(robot, "LeftWheel", 0.13, 0, 1);
        wheel(robot, "RightWheel", -0.13, 0, 1);
        wheel(robot, "FrontWheel", 0, 0.14, 0);
        wheel(robot, "BackWheel", 0, -0.14, 0);
        robot.addComponent(new Dynamics("Dynamics", 2.5, 60, 0.5, 0.6, 1000, 0.02, 0, 0.1, 0, 0, 0, 0));
        LIDAR lidar = new LIDAR("LIDAR1");
        lidar.move(0, 0.15, 0);
        robot.addComponent(lidar);
        Distance ping = new Distance("Ping1", "PING)))");
        ping.move(0, 0.08, 0.17);
        robot.addComponent(ping);
        robot.addComponent(new GPS("GPS1", 35.2, 200, -97.4));
        robot.addComponent(new Compass("Compass1"));
        robot.addComponent(new Accelerometer("Accel1"));
        robot.addComponent(new Gyroscope("Gyro1"));
        robot.addComponent(new Odometer("Odometer1"));
    }

    private static void wheel(SEARrobot robot, String name, double x, double z, int type) {
        Wheel wheel = new Wheel(name, 0.035, 0.02, type);
        wheel.move(x, -0.02, z);
        robot.addWheel(wheel);
    }

    private static void paint(Path file, Color color) throws IOException {
        BufferedImage image = new BufferedImage(16, 16, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 16 * 16; i++) {
            image.setRGB(i % 16, i / 16, color.getRGB());
        }
        ImageIO.write(image, "png", file.toFile());
    }
}
