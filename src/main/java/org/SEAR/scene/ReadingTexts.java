// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.Project;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.SensorTypes;

/** Readings of a project's sensors as text with unit. Immutable, any thread. */
public final class ReadingTexts {
    /** Unit of each sensor's reading, in the project's order. */
    private final Map<String, String> units = new LinkedHashMap<>();
    /** Text shown for a camera without viewers: its picture size. */
    private final Map<String, String> cameras = new LinkedHashMap<>();

    public ReadingTexts(Project project) {
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
     * Returns a sensor's reading as text; null if there is none.
     * @param sensor full name
     * @param reading null for none
     */
    public String of(String sensor, Reading reading) {
        return reading == null ? cameras.get(sensor) : reading.words(units.get(sensor));
    }

    /** Returns the texts of these readings by sensor, in the project's order. */
    public Map<String, String> of(Map<String, Reading> readings) {
        Map<String, String> texts = new LinkedHashMap<>();
        for (String sensor : units.keySet()) {
            String text = of(sensor, readings.get(sensor));
            if (text != null) {
                texts.put(sensor, text);
            }
        }
        return texts;
    }
}
