// SPDX-License-Identifier: Apache-2.0
package org.example;

import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.Hit;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.SensorType;
import org.SEAR.sensors.Truth;

/** A beam per pixel, in steps of 7.5 degrees around the forward axis, sees objects up to 7 m away. */
public final class ThermalGridSensor extends Sensor<ThermalImage> {
    private static final double STEP = Math.toRadians(7.5);
    private static final double RANGE = 7;

    private final ThermalGrid grid;
    private final Hit hit = new Hit();

    /** @param seed of the simulation */
    public ThermalGridSensor(ThermalGrid parameters, long seed) {
        super(parameters, seed, 1);
        this.grid = parameters;
    }

    @Override
    protected ThermalImage measure(Truth truth) {
        double[] pixels = new double[ThermalImage.SIDE * ThermalImage.SIDE];
        for (int i = 0; i < pixels.length; i++) {
            double left = STEP * ((ThermalImage.SIDE - 1) / 2.0 - i % ThermalImage.SIDE);
            double up = STEP * ((ThermalImage.SIDE - 1) / 2.0 - i / ThermalImage.SIDE);
            pixels[i] = errors.apply(seen(truth, pose(truth), left, up), truth.step(), 0, i);
        }
        return new ThermalImage(pixels);
    }

    private double seen(Truth truth, Pose pose, double left, double up) {
        double[] way = pose.rotate(Math.cos(up) * Math.sin(left), Math.sin(up), Math.cos(up) * Math.cos(left));
        double distance = truth.scene().cast(pose.x, pose.y, pose.z, way[0], way[1], way[2], RANGE, truth.owner(), hit);
        return distance < RANGE && !truth.isGround(hit.shape) ? grid.getThings() : grid.getAir();
    }

    /** The registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return ThermalGrid.class;
        }

        @Override
        public String description() {
            return "temperatures of 8 x 8 pixels, row by row from the top left: degrees Celsius";
        }

        @Override
        public String unit() {
            return "degC";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new ThermalGridSensor((ThermalGrid) parameters, seed);
        }
    }
}
