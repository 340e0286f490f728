// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.Project;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.SensorTypes;
import org.SEAR.simulator.Snapshot;

/** Creates the scene states of one world. One thread at a time. */
public final class SceneStates {
    /** Unit of each sensor's reading. */
    private final Map<String, String> units = new LinkedHashMap<>();
    /** Text shown for a camera without viewers: its picture size. */
    private final Map<String, String> cameras = new LinkedHashMap<>();

    public SceneStates(Project project) {
        SensorTypes types = SensorTypes.load();
        for (SEARrobot robot : project.getRobots()) {
            for (SearObject part : robot.getComponents()) {
                units.put(part.getFullName(), types.unit(part));
                if (part instanceof Camera) {
                    cameras.put(part.getFullName(), ((Camera) part).getWidth() + " x " + ((Camera) part).getHeight());
                }
            }
        }
    }

    /**
     * Returns the scene of a snapshot.
     * @param readings returns a sensor's reading by full name; null if unknown
     */
    public SceneState of(Snapshot snapshot, Function<String, Reading> readings) {
        List<SceneState.RobotState> robots = new ArrayList<>();
        for (Snapshot.RobotState state : snapshot.robots) {
            robots.add(new SceneState.RobotState(state.name, state.pose, state.speed, state.turnRate, state.wheels, state.parts,
                state.lights, state.devices.stream().map(Snapshot.DeviceState::toString).collect(Collectors.toList())));
        }
        Map<String, double[]> beams = new LinkedHashMap<>();
        Map<String, String> values = new LinkedHashMap<>();
        for (Map.Entry<String, String> sensor : units.entrySet()) {
            Reading reading = readings.apply(sensor.getKey());
            if (reading == null && cameras.containsKey(sensor.getKey())) {
                values.put(sensor.getKey(), cameras.get(sensor.getKey()));
            }
            if (reading != null) {
                values.put(sensor.getKey(), reading.words(sensor.getValue()));
                double[] lengths = reading.beams();
                if (lengths != null) {
                    beams.put(sensor.getKey(), lengths);
                }
            }
        }
        return new SceneState(snapshot.step, snapshot.time, snapshot.environment, robots, beams, values, snapshot.contacts, snapshot.warnings);
    }
}
