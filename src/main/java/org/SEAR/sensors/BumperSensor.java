package org.SEAR.sensors;

import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.SearObject;

/**
 * Whether a part of the robot touches something: true while it does. Errors count on a scale on which 0 is free, 1 is pressed, and the contact closes
 * above the middle; a reading that dropped out is false.
 */
public final class BumperSensor extends Sensor<Switch> {
    private static final double CLOSES = 0.5;

    private final String part;

    /** @param seed of the simulation */
    public BumperSensor(Bumper parameters, long seed) {
        super(parameters, seed, 1);
        this.part = parameters.getPart();
    }

    @Override
    protected Switch measure(Truth truth) {
        return new Switch(!errors.drops(truth.step(), 0) && errors.apply(truth.isTouched(part) ? 1 : 0, truth.step(), 0, 0) > CLOSES);
    }

    /** The registry entry. */
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
