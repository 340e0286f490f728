package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.SEAR.geometry.Pose;
import org.SEAR.robot.RobotModel;

/** Makes the snapshots. What did not change is shared with the snapshot before. Simulation thread. */
final class SnapshotRecorder {
    private static final int DEFAULT_INTERVAL = 2;
    /** A robot whose up axis points lower than this (its vertical part) lies on its side or back. */
    private static final double OVERTURNED = 0.3;

    private final World world;
    private final Instruments instruments;
    private final Warnings warnings;
    private final TreeSet<String> watched = new TreeSet<>();
    private int interval = DEFAULT_INTERVAL;
    private Map<String, Object> readings = Collections.emptyMap();
    private final Snapshot.RobotState[] states;
    private final List<List<String>> status = new ArrayList<>();
    private final boolean[] commanded;

    SnapshotRecorder(World world, Instruments instruments, Warnings warnings) {
        this.world = world;
        this.instruments = instruments;
        this.warnings = warnings;
        states = new Snapshot.RobotState[world.getRobots().size()];
        commanded = new boolean[states.length];
        for (int i = 0; i < states.length; i++) {
            status.add(List.of());
        }
    }

    void watch(String sensor, boolean on) {
        if (on) {
            watched.add(sensor);
        } else {
            watched.remove(sensor);
        }
        readings = readings();
    }

    void setInterval(int steps) {
        interval = steps;
    }

    Snapshot look(long step) {
        boolean display = step % interval == 0;
        if (display && !watched.isEmpty()) {
            readings = readings();
        }
        for (int i = 0; i < states.length; i++) {
            RobotModel robot = world.getRobots().get(i);
            boolean changed = display && updateStatus(i);
            if (step == 0 || changed || states[i] == null || world.getPhysics().isAwake(robot.getBody()) || states[i].speed != 0) {
                states[i] = state(robot, status.get(i), commanded[i]);
                check(robot);
            }
        }
        return new Snapshot(step, step * Simulation.STEP, world.getPoses(), List.of(states), readings, world.getContacts(), warnings.list());
    }

    private Map<String, Object> readings() {
        Map<String, Object> now = new LinkedHashMap<>();
        for (String name : watched) {
            now.put(name, instruments.read(name));
        }
        return Collections.unmodifiableMap(now);
    }

    private boolean updateStatus(int number) {
        RobotModel robot = world.getRobots().get(number);
        List<String> old = status.get(number);
        List<String> now = null;
        boolean wasCommanded = commanded[number];
        commanded[number] = false;
        for (int i = 0; i < instruments.getPorts().size(); i++) {
            Port port = instruments.getPorts().get(i);
            if (port.getRobot() == robot) {
                now = now == null ? new ArrayList<>() : now;
                now.add(port.getCable().getObjectName() + ": " + port.getCable().getDevice().status());
                commanded[number] |= port.getCable().getDevice().takesDriveCommands();
            }
        }
        if (now == null || now.equals(old)) {
            return commanded[number] != wasCommanded;
        }
        status.set(number, List.copyOf(now));
        return true;
    }

    private static Snapshot.RobotState state(RobotModel robot, List<String> status, boolean commanded) {
        Pose pose = robot.getPose();
        double[] velocity = robot.truth().velocity();
        double[] angular = robot.truth().angularVelocity();
        double[] ahead = pose.rotate(0, 0, 1);
        double[] up = pose.rotate(0, 1, 0);
        return new Snapshot.RobotState(robot.getObject().getName(), pose,
            velocity[0] * ahead[0] + velocity[1] * ahead[1] + velocity[2] * ahead[2],
            angular[0] * up[0] + angular[1] * up[1] + angular[2] * up[2], robot.getTrain().getWheelPoses(), status, commanded);
    }

    private void check(RobotModel robot) {
        Pose pose = robot.getPose();
        if (1 - 2 * (pose.qx * pose.qx + pose.qz * pose.qz) < OVERTURNED) {
            warnings.add("robot " + robot.getObject().getName() + " has overturned");
        }
    }
}
