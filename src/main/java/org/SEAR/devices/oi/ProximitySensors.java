// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import org.SEAR.devices.RobotHardware;

/** The robot's short-range sensors: cliff sensors, wall sensor and light bumpers. Distances in metres. */
final class ProximitySensors {
    /** Bearings of the four cliff sensors, degrees from forward, + left: left, front left, front right, right. */
    private static final double[] CLIFFS = {60, 10, -10, -60};
    /** Distance of the cliff sensors from the middle, as a share of the body's radius; just inside the bumper's rim. */
    private static final double CLIFF_RADIUS = 0.99;
    /**
     * Minimum lead of the cliff sensors over the foremost axle, metres. The supporting front wheel must stop before the
     * edge.
     */
    private static final double CLIFF_LEAD = 0.04;
    /** Minimum drop of the ground from that under the robot's middle, metres, that counts as a cliff. */
    private static final double CLIFF_DEPTH = 0.03;
    private static final double GROUND_RANGE = 1;
    private static final double WALL_BEARING = -60;
    private static final double WALL_RANGE = 0.1;
    private static final double WALL_NEAR = 0.05;
    /**
     * Bearings of the six light bumpers, degrees from forward, + left: left, front left, centre left, centre right,
     * front right, right.
     */
    private static final double[] LIGHT_BUMPERS = {65, 38, 12, -12, -38, -65};
    private static final double LIGHT_RANGE = 0.1;
    private static final int SIGNAL_MAX = 4095;
    private static final int FLOOR_SIGNAL = 2000;

    private final RobotHardware hardware;
    private final int wallSignalMax;
    private double ground = Double.POSITIVE_INFINITY;

    /** @param wallSignalMax maximum of packet 27 */
    public ProximitySensors(RobotHardware hardware, int wallSignalMax) {
        this.hardware = hardware;
        this.wallSignalMax = wallSignalMax;
    }

    void reset() {
        ground = Double.POSITIVE_INFINITY;
    }

    /** @param which 0 left, 1 front left, 2 front right, 3 right */
    boolean isCliff(int which) {
        double middle = down(0, 0);
        if (middle < GROUND_RANGE) {
            ground = middle;
        }
        double angle = Math.toRadians(CLIFFS[which]);
        double radius = Math.max(hardware.getBodyRadius() * CLIFF_RADIUS, hardware.getFrontAxle() + CLIFF_LEAD);
        return Double.isFinite(ground) && down(radius * Math.sin(angle), radius * Math.cos(angle)) > ground
            + CLIFF_DEPTH;
    }

    boolean isAnyCliff() {
        return isCliff(0) || isCliff(1) || isCliff(2) || isCliff(3);
    }

    int cliffSignal(int which) {
        return isCliff(which) ? 0 : FLOOR_SIGNAL;
    }

    boolean isWall() {
        return ahead(WALL_BEARING, WALL_RANGE) <= WALL_NEAR;
    }

    int wallSignal() {
        return signal(ahead(WALL_BEARING, WALL_RANGE), WALL_RANGE, wallSignalMax);
    }

    int lightSignal(int which) {
        return signal(ahead(LIGHT_BUMPERS[which], LIGHT_RANGE), LIGHT_RANGE, SIGNAL_MAX);
    }

    /** Packet 45: bit 0 left to bit 5 right. */
    int lightBumpers() {
        int bits = 0;
        for (int i = 0; i < LIGHT_BUMPERS.length; i++) {
            bits |= lightSignal(i) > 0 ? 1 << i : 0;
        }
        return bits;
    }

    private static int signal(double distance, double range, int max) {
        return distance >= range ? 0 : (int) Math.round(max * (1 - Math.max(0, distance) / range));
    }

    private double down(double x, double z) {
        return hardware.look(x, 0, z, 0, -1, 0, GROUND_RANGE);
    }

    /** Distance from the body's edge to the nearest object at a bearing. */
    private double ahead(double bearing, double range) {
        double angle = Math.toRadians(bearing);
        double radius = hardware.getBodyRadius();
        return hardware.look(0, 0, 0, Math.sin(angle), 0, Math.cos(angle), radius + range) - radius;
    }
}
