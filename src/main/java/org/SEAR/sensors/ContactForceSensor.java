// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.ContactForce;
import org.SEAR.POJOs.SearObject;

/**
 * Sum of the normal forces of all contacts on a part of the robot, the mean of the last step, N. NaN for a dropped
 * reading.
 */
public final class ContactForceSensor extends Sensor<Quantity> {
    private static final int DIGITS = 3;

    private final String part;

    /** @param seed random seed of the simulation */
    public ContactForceSensor(ContactForce parameters, long seed) {
        super(parameters, seed, 1);
        this.part = parameters.getPart();
    }

    @Override
    protected Quantity measure(Truth truth) {
        return new Quantity(errors.drops(truth.step(), 0) ? Double.NaN
            : errors.apply(truth.contactForce(part), truth.step(), 0, 0), DIGITS);
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return ContactForce.class;
        }

        @Override
        public String description() {
            return "force of the contacts on a part of the robot: sum of the normal forces in N";
        }

        @Override
        public String unit() {
            return "N";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new ContactForceSensor((ContactForce) parameters, seed);
        }
    }
}
