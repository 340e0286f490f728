// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import java.util.function.Consumer;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;

/**
 * A robot with a LIDAR of some model among objects: a wall 2.9 m ahead, a crate to the left, one behind, a pillar,
 * nothing to the right.
 */
public final class ScannedRoom {
    /** Distance of the wall straight ahead, metres. */
    static final double WALL = 2.9;
    public static final String PORT = "/dev/SEAR_LIDAR_01";

    private ScannedRoom() {
    }

    /**
     * Makes the objects.
     * @param settings sets the LIDAR's parameters besides its model
     */
    public static void build(String model, Consumer<LIDAR> settings) {
        new Floor("floor", 20, 20);
        new Box("ahead", 6, 0.2, 1, 0).move(0, 0.5, WALL + 0.1);
        new Box("left", 1, 1, 1, 0).move(3, 0.5, 1);
        new Cylinder("pillar", 0.2, 1, 0).move(-2, 0.5, 1.5);
        new Box("behind", 1, 1, 1, 0).move(0.5, 0.5, -2);
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 3.6, 60, 0.3, 0.4, 1000, 0.1, 0, 0.1, 0, 0, 0, 0));
        robot.addComponent(new Cylinder("body", 0.17, 0.07, 3));
        double[][] wheels = {{-0.1175, 0, 1}, {0.1175, 0, 1}, {0, 0.13, 0}, {0, -0.13, 0}};
        for (double[] at : wheels) {
            Wheel wheel = new Wheel("wheel" + at[0] + at[1], 0.036, 0.02, (int) at[2]);
            wheel.move(at[0], 0, at[1]);
            robot.addWheel(wheel);
        }
        LIDAR scanner = new LIDAR("scanner");
        scanner.setModel(model);
        scanner.setPorts("/dev/my_Lidar01", PORT);
        scanner.move(0, 0.15, 0);
        settings.accept(scanner);
        robot.addComponent(scanner);
    }
}
