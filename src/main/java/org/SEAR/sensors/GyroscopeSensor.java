// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Rotation;

/**
 * Rates of turn about the sensor's axes, rad/s, counter-clockwise positive (without rotation: +x left, +y up, +z
 * forward; a left turn is +y). Reading = mean over the window 1/bandwidth of R_i' omega_i. No error unless the object
 * has noise.
 */
public final class GyroscopeSensor extends InertialSensor {
    private final Rotation rotation = new Rotation();

    /** @param seed random seed of the simulation */
    public GyroscopeSensor(Gyroscope parameters, long seed) {
        super(parameters, parameters.getBandwidth(), seed);
    }

    /** Part of another sensor, without errors. */
    GyroscopeSensor(SearObject parameters, double bandwidth) {
        super(parameters, bandwidth);
    }

    @Override
    public void track(Truth truth) {
        super.track(truth);
        double[] w = truth.angularVelocity();
        rotation.set(truth.body());
        double x = rotation.inX(w[0], w[1], w[2]);
        double y = rotation.inY(w[0], w[1], w[2]);
        double z = rotation.inZ(w[0], w[1], w[2]);
        rotation.set(getMount());
        add(truth, rotation.inX(x, y, z), rotation.inY(x, y, z), rotation.inZ(x, y, z));
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Gyroscope.class;
        }

        @Override
        public String description() {
            return "rates of turn about the sensor's axes (+x left, +y up, +z forward), counter-clockwise positive: "
                + "three numbers in rad/s";
        }

        @Override
        public String unit() {
            return "rad/s";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new GyroscopeSensor((Gyroscope) parameters, seed);
        }
    }
}
