// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.SEAR.devices.Cable;
import org.SEAR.devices.PinState;
import org.SEAR.geometry.Pose;
import org.SEAR.robot.RobotModel;
import org.SEAR.sensors.Reading;

/** Makes the snapshots; they share unchanged parts with the snapshot before. Simulation thread. */
final class SnapshotRecorder {
    private static final int DEFAULT_INTERVAL = 2;
    /** Vertical component of the up axis below which a robot lies on its side or back. */
    private static final double OVERTURNED = 0.3;

    private final World world;
    private final Instruments instruments;
    private final SimulationWarnings warnings;
    private final TreeSet<String> watched = new TreeSet<>();
    private int interval = DEFAULT_INTERVAL;
    private Map<String, Reading> readings = Collections.emptyMap();
    private final Snapshot.RobotState[] states;
    private final List<List<Snapshot.DeviceState>> devices = new ArrayList<>();
    /** Cables of each robot. */
    private final List<List<Cable>> cables = new ArrayList<>();
    private final boolean[] commanded;

    SnapshotRecorder(World world, Instruments instruments, SimulationWarnings warnings) {
        this.world = world;
        this.instruments = instruments;
        this.warnings = warnings;
        states = new Snapshot.RobotState[world.getRobots().size()];
        commanded = new boolean[states.length];
        for (int i = 0; i < states.length; i++) {
            RobotModel robot = world.getRobots().get(i);
            devices.add(List.of());
            cables.add(instruments.getPorts().stream().filter(port -> port.getRobot() == robot)
                .map(DevicePort::getCable).collect(Collectors.toList()));
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
        return look(step, step % interval == 0);
    }

    /** Makes a snapshot with the present readings and device states, regardless of the display interval. */
    Snapshot lookClosely(long step) {
        return look(step, true);
    }

    private Snapshot look(long step, boolean display) {
        if (display && !watched.isEmpty()) {
            readings = readings();
        }
        for (int i = 0; i < states.length; i++) {
            RobotModel robot = world.getRobots().get(i);
            boolean changed = display && updateDevices(i);
            if (step == 0 || changed || states[i] == null || world.getPhysics().isAwake(robot.getBody())
                || states[i].speed != 0 || states[i].lights != robot.getLights()) {
                states[i] = state(robot, devices.get(i), commanded[i]);
                check(robot);
            }
        }
        return new Snapshot(step, step * Simulation.STEP, world.getPoses(), List.of(states), readings,
            world.getContacts(), warnings.list());
    }

    private Map<String, Reading> readings() {
        Map<String, Reading> now = new LinkedHashMap<>();
        Iterator<Reading> read = instruments.read(watched).iterator();
        for (String name : watched) {
            now.put(name, read.next());
        }
        return Collections.unmodifiableMap(now);
    }

    private boolean updateDevices(int number) {
        List<Snapshot.DeviceState> old = devices.get(number);
        List<Snapshot.DeviceState> now = null;
        boolean wasCommanded = commanded[number];
        commanded[number] = false;
        for (int i = 0; i < cables.get(number).size(); i++) {
            Cable cable = cables.get(number).get(i);
            commanded[number] |= cable.takesDriveCommands();
            Snapshot.DeviceState before = i < old.size() ? old.get(i) : null;
            Snapshot.DeviceState after = after(before, cable);
            if (after != before) {
                now = now == null ? new ArrayList<>(old) : now;
                put(now, i, after);
            }
        }
        if (now == null) {
            return commanded[number] != wasCommanded;
        }
        devices.set(number, List.copyOf(now));
        return true;
    }

    /** @return {@code before} if the state has not changed */
    private static Snapshot.DeviceState after(Snapshot.DeviceState before, Cable cable) {
        String status = cable.status();
        List<PinState> pins = cable.pinStates();
        boolean same = before != null && before.powered == cable.isPowered() && before.status.equals(status)
            && before.pins.equals(pins);
        return same ? before : new Snapshot.DeviceState(cable.getObjectName(), cable.isPowered(), status, pins);
    }

    private static void put(List<Snapshot.DeviceState> list, int at, Snapshot.DeviceState state) {
        if (at < list.size()) {
            list.set(at, state);
        } else {
            list.add(state);
        }
    }

    private static Snapshot.RobotState state(RobotModel robot, List<Snapshot.DeviceState> devices, boolean commanded) {
        Pose pose = robot.getPose();
        double[] velocity = robot.truth().velocity();
        double[] angular = robot.truth().angularVelocity();
        double[] ahead = pose.rotate(0, 0, 1);
        double[] up = pose.rotate(0, 1, 0);
        return new Snapshot.RobotState(robot.getObject().getName(), pose,
            velocity[0] * ahead[0] + velocity[1] * ahead[1] + velocity[2] * ahead[2],
            angular[0] * up[0] + angular[1] * up[1] + angular[2] * up[2], robot.getTrain().getWheelPoses(),
            robot.getPartPoses(), robot.getLights(), devices, commanded);
    }

    private void check(RobotModel robot) {
        Pose pose = robot.getPose();
        if (1 - 2 * (pose.qx * pose.qx + pose.qz * pose.qz) < OVERTURNED) {
            warnings.add("robot " + robot.getObject().getName() + " has overturned");
        }
    }
}
