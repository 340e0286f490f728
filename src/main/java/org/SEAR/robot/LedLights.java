// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.LightHardware;
import org.SEAR.grammar.Parameter;

/** LEDs of one robot. Simulation thread. */
final class LedLights {
    private final List<Light> lights = new ArrayList<>();
    private List<Double> shown = List.of();

    LedLights(RobotBuilder from) {
        for (SearObject part : from.object.getComponents()) {
            if (part instanceof Led) {
                lights.add(new Light(part.getName(), from.object.getName()));
            }
        }
        restart();
    }

    /** Turns all LEDs off. */
    void restart() {
        lights.forEach(light -> light.brightness = 0);
        show();
    }

    private void show() {
        Double[] now = new Double[lights.size()];
        for (int i = 0; i < now.length; i++) {
            now[i] = lights.get(i).brightness;
        }
        shown = List.of(now);
    }

    /** Brightness of each LED, 0 to 1, in the order of the components; the same list until one changes. Immutable. */
    List<Double> getShown() {
        return shown;
    }

    /** Returns the LED of this name; null if there is none. */
    LightHardware find(String name) {
        return lights.stream().filter(light -> light.name.equals(name)).findFirst().orElse(null);
    }

    private final class Light implements LightHardware {
        private final String name;
        private final String robot;
        private double brightness;

        Light(String name, String robot) {
            this.name = name;
            this.robot = robot;
        }

        @Override
        public String getName() {
            return name;
        }

        @Override
        public void setBrightness(double wanted) {
            if (!(wanted >= 0 && wanted <= 1)) {
                throw new IllegalArgumentException("led " + name + " of robot " + robot + ": brightness is "
                    + Parameter.format(wanted) + ", legal: 0 to 1");
            }
            if (wanted != brightness) {
                brightness = wanted + 0.0;
                show();
            }
        }

        @Override
        public double getBrightness() {
            return brightness;
        }
    }
}
