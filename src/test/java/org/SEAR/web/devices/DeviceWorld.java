// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.devices;

import org.SEAR.web.MyRobotLab;

/**
 * A world whose scans can be computed by hand. The robot's LIDAR and GPS are ready on their ports: a wall 1.9 m before
 * the LIDAR, a crate 0.8 m to its left, nothing to its right.
 */
public final class DeviceWorld {
    public static final String LIDAR_PORT = "/dev/SEAR_LIDAR_01";
    public static final String GPS_PORT = "/dev/SEAR_GPS_01";
    static final String ROBOT_PORT = "/dev/SEAR_Robot_01";
    /** Distance of the wall straight ahead, metres. */
    public static final double AHEAD = 1.9;
    /** Distance of the crate to the left, metres. */
    static final double LEFT = 0.8;

    /** Starts the world with the services sear, lidar and gps. */
    public static final String SCRIPT = String.join("\n",
        "sear = Runtime.start('sear', 'SEAR')",
        "from org.SEAR.POJOs import Box, Cylinder, Dynamics, Floor, GPS, LIDAR, SEARrobot, Wheel",
        "Floor('floor', 40, 40, False)",
        "Box('wall', 20, 0.2, 1, 0).move(0, 0.5, 2.1)",
        "Box('crate', 0.4, 0.4, 0.4, 0).move(1.0, 0.2, 0.1)",
        "robot = SEARrobot('roomba')",
        "drive = Dynamics('drive', 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0)",
        "drive.setPorts('/dev/my_Robot01', '" + ROBOT_PORT + "')",
        "robot.addComponent(drive)",
        "robot.addComponent(Cylinder('body', 0.1666875, 0.0762, 4))",
        "for (name, x, z, driven) in (('front', 0, 0.16, 0), ('right', -0.129, 0, 1), ('left', 0.129, 0, 1), ('back', "
        + "0, -0.16, 0)):", "    wheel = Wheel(name, 0.0381, 0.03, driven)",
        "    wheel.move(x, 0, z)",
        "    robot.addWheel(wheel)",
        "scanner = LIDAR('scanner', 8.191, 180, 1, 0, 0.15, 0.1)",
        "scanner.setPorts('/dev/my_Lidar01', '" + LIDAR_PORT + "')",
        "scanner.setBaud(38400)",
        "scanner.LMS(1)",
        "robot.addComponent(scanner)",
        "receiver = GPS('receiver', 33.61, 182.5, -80.865)",
        "receiver.setPorts('/dev/my_GPS_01', '" + GPS_PORT + "')",
        "robot.addComponent(receiver)",
        "Runtime.start('lidar', 'LIDAR')",
        "Runtime.start('gps', 'GPS')");

    private DeviceWorld() {
    }

    /** Restarts the simulation, so that the devices are in their power-on state. */
    public static void restart(MyRobotLab robotLab) {
        robotLab.call("lidar", "disconnect");
        robotLab.call("gps", "disconnect");
        if (robotLab.call("sear", "isSimulating").asBoolean()) {
            robotLab.call("sear", "stopSimulation");
        }
        robotLab.call("sear", "startSimulation");
    }
}
