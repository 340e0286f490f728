// SPDX-License-Identifier: Apache-2.0
package org.example;

import org.SEAR.POJOs.SearObject;
import org.SEAR.sensors.Quantity;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.SensorType;
import org.SEAR.sensors.Truth;

/** Temperature at the sensor: ground - lapse * height, degrees Celsius; NaN for a dropped reading. */
public final class ThermometerSensor extends Sensor<Quantity> {
    private final Thermometer thermometer;

    /** @param seed of the simulation */
    public ThermometerSensor(Thermometer parameters, long seed) {
        super(parameters, seed, 1);
        this.thermometer = parameters;
    }

    @Override
    protected Quantity measure(Truth truth) {
        if (errors.drops(truth.step(), 0)) {
            return new Quantity(Double.NaN);
        }
        double celsius = thermometer.getGround() - thermometer.getLapse() * pose(truth).y;
        return new Quantity(errors.apply(celsius, truth.step(), 0, 0));
    }

    /** The registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Thermometer.class;
        }

        @Override
        public String description() {
            return "temperature at the sensor: degrees Celsius";
        }

        @Override
        public String unit() {
            return "degC";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new ThermometerSensor((Thermometer) parameters, seed);
        }
    }
}
