// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.LineSensor;
import org.SEAR.POJOs.SearObject;

/**
 * Light reflected by a spot, percent, weighted as luminance (Rec. 709): black and nothing in range are 0, white is 100.
 * NaN after a drop-out.
 */
public final class ReflectanceSensor extends Sensor<Quantity> {
    private static final double RED = 0.2126;
    private static final double GREEN = 0.7152;
    private static final double BLUE = 0.0722;
    private static final double PERCENT = 100;
    /** Supply voltage, volts. */
    private static final double SUPPLY = 5;

    private final LightSpot spot;

    /** @param seed random seed of the simulation */
    public ReflectanceSensor(LineSensor parameters, long seed) {
        super(parameters, seed, 1);
        this.spot = new LightSpot(parameters);
    }

    @Override
    protected Quantity measure(Truth truth) {
        if (errors.drops(truth.step(), 0)) {
            return new Light(Double.NaN);
        }
        double[] light = spot.look(truth, pose(truth));
        double percent = PERCENT * (RED * light[0] + GREEN * light[1] + BLUE * light[2]);
        return new Light(Math.max(0, Math.min(PERCENT, errors.apply(percent, truth.step(), 0, 0))));
    }

    /** Reflected light, and the output of a phototransistor with a resistor: light pulls it down. */
    private static final class Light extends Quantity {
        Light(double percent) {
            super(percent, 1);
        }

        /** Returns 0 for white to 5 for black. */
        @Override
        public double volts() {
            return SUPPLY * (1 - get() / PERCENT);
        }
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return LineSensor.class;
        }

        @Override
        public String description() {
            return "light reflected by the spot: 0 % for black or nothing in range, 100 % for white";
        }

        @Override
        public String unit() {
            return "%";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new ReflectanceSensor((LineSensor) parameters, seed);
        }
    }
}
