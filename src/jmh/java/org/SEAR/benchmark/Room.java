// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.geometry.Pose;

/**
 * Static surroundings of a robot: a walled square with rotated fixed boxes of 0.25 to 1 m outside the robot's circle.
 * {@code room-N} is 10 m x 10 m; {@code hall-N} grows at 20 boxes per 100 m^2. Equal names give equal rooms.
 */
final class Room {
    /** Length of the room's side, metres. */
    private static final double ROOM = 10;
    private static final double SPARSE = 20;
    private static final double WALL = 0.1;
    private static final double WALL_HEIGHT = 2;
    /** Minimum distance of boxes from the centre, metres. */
    private static final double CLEAR = 2.3;

    /** Length of the square's side, metres. */
    final double side;
    /** Nine numbers per box, walls first: full sizes along x, y, z, position, rotation in degrees. */
    final double[][] boxes;

    Room(String name) {
        int number = Integer.parseInt(name.substring(name.indexOf('-') + 1));
        side = name.startsWith("hall") ? ROOM * Math.sqrt(number / SPARSE) : ROOM;
        boxes = new double[number + 4][];
        for (int wall = 0; wall < 4; wall++) {
            double at = (wall % 2 == 0 ? 1 : -1) * (side + WALL) / 2;
            boxes[wall] = wall < 2 ? new double[] {side, WALL_HEIGHT, WALL, 0, WALL_HEIGHT / 2, at, 0, 0, 0}
                : new double[] {WALL, WALL_HEIGHT, side, at, WALL_HEIGHT / 2, 0, 0, 0, 0};
        }
        Random random = new Random(2026);
        for (int i = 4; i < boxes.length; i++) {
            double x;
            double z;
            do {
                x = (random.nextDouble() - 0.5) * (side - 1);
                z = (random.nextDouble() - 0.5) * (side - 1);
            } while (Math.hypot(x, z) < CLEAR);
            boxes[i] = new double[] {size(random), size(random), size(random), x, 0.5, z, 360 * random.nextDouble(),
                360 * random.nextDouble(), 360 * random.nextDouble()};
        }
    }

    private static double size(Random random) {
        return 0.25 + 0.75 * random.nextDouble();
    }

    /** Adds all objects to the present project. */
    void build() {
        new Floor("floor", side, side);
        for (int i = 0; i < boxes.length; i++) {
            add("box" + i, boxes[i], 0);
        }
    }

    /**
     * Adds a box of nine numbers to the present project.
     * @param mass kg, 0 for a fixed box
     */
    static void add(String name, double[] b, double mass) {
        new Box(name, b[0], b[2], b[1], mass, b[3], b[4], b[5], b[6], b[7], b[8]);
    }

    /** Converts a box to ten numbers: half sizes, position, quaternion. */
    static double[] posed(double[] b) {
        Pose pose = Pose.ofDegrees(b[3], b[4], b[5], b[6], b[7], b[8]);
        return new double[] {b[0] / 2, b[1] / 2, b[2] / 2, pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw};
    }
}
