// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.ColorSensor;
import org.SEAR.POJOs.SearObject;

/**
 * Mean colour of a spot, averaged in linear light; black without anything in range. Errors apply to each of the three
 * numbers.
 */
public final class SpotColorSensor extends Sensor<ColorReading> {
    private static final int CHANNELS = 3;
    private static final double FULL = 255;

    private final LightSpot spot;

    /** @param seed random seed of the simulation */
    public SpotColorSensor(ColorSensor parameters, long seed) {
        super(parameters, seed, CHANNELS);
        this.spot = new LightSpot(parameters);
    }

    @Override
    protected ColorReading measure(Truth truth) {
        if (errors.drops(truth.step(), 0)) {
            return new ColorReading(Double.NaN, Double.NaN, Double.NaN);
        }
        double[] light = spot.look(truth, pose(truth));
        return new ColorReading(value(light[0], truth, 0), value(light[1], truth, 1), value(light[2], truth, 2));
    }

    private double value(double light, Truth truth, int channel) {
        return Math.max(0, Math.min(FULL, errors.apply(LightSpot.picture(light), truth.step(), channel, channel)));
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return ColorSensor.class;
        }

        @Override
        public String description() {
            return "colour of the spot: red, green and blue, 0 to 255; black if nothing is in range";
        }

        @Override
        public String unit() {
            return "of 255";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new SpotColorSensor((ColorSensor) parameters, seed);
        }
    }
}
