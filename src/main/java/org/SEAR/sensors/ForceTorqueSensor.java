// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;

/**
 * Mean force and torque of the last step on a joint's second object, at the joint, along the sensor's axes: without
 * rotation those of the robot's body, +x left, +y up, +z forward. NaN for a dropped reading.
 */
public final class ForceTorqueSensor extends Sensor<WrenchReading> {
    private final String joint;
    private final double[] wrench = new double[WrenchReading.SIZE];

    /** @param seed random seed of the simulation */
    public ForceTorqueSensor(ForceTorque parameters, long seed) {
        super(parameters, seed, WrenchReading.SIZE);
        joint = parameters.getJoint();
    }

    @Override
    protected WrenchReading measure(Truth truth) {
        truth.wrench(joint, wrench);
        Pose pose = pose(truth);
        double[] force = pose.rotateBack(wrench[0], wrench[1], wrench[2]);
        double[] torque = pose.rotateBack(wrench[3], wrench[4], wrench[5]);
        double[] read = new double[WrenchReading.SIZE];
        boolean drops = errors.drops(truth.step(), 0);
        for (int i = 0; i < read.length; i++) {
            read[i] = drops ? Double.NaN : errors.apply(i < 3 ? force[i] : torque[i - 3], truth.step(), i, i);
        }
        return new WrenchReading(read);
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return ForceTorque.class;
        }

        @Override
        public String description() {
            return "force and torque of a joint on its second object, along the sensor's axes (+x left, +y up, +z "
                + "forward): six numbers in N and N m";
        }

        @Override
        public String unit() {
            return WrenchReading.UNIT;
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new ForceTorqueSensor((ForceTorque) parameters, seed);
        }
    }
}
