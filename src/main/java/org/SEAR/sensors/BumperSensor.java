// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.SearObject;

/**
 * True while a part of the robot touches something. Errors apply on a scale where 0 is free and 1 is pressed; the
 * switch closes above 0.5. A dropped-out reading is false.
 */
public final class BumperSensor extends Sensor<Switch> {
    private static final double CLOSES = 0.5;

    private final String part;

    /** @param seed random seed of the simulation */
    public BumperSensor(Bumper parameters, long seed) {
        super(parameters, seed, 1);
        this.part = parameters.getPart();
    }

    @Override
    protected Switch measure(Truth truth) {
        return new Switch(!errors.drops(truth.step(), 0)
            && errors.apply(truth.isTouched(part) ? 1 : 0, truth.step(), 0, 0) > CLOSES);
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Bumper.class;
        }

        @Override
        public String description() {
            return "whether a part of the robot touches anything else: True while it is pressed";
        }

        @Override
        public String unit() {
            return "pressed";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new BumperSensor((Bumper) parameters, seed);
        }
    }
}
