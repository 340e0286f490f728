// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.devices.ServoHardware;

/**
 * The wire of a servo. A pulse of 1472 us, an Arduino's 90 degrees, is the servo's 0 degrees. Longer pulses turn it
 * counter-clockwise, one degree per 10.31 us as in the Servo library. The angle is limited to the servo's range.
 * Without pulses the servo keeps its last target.
 */
final class ServoWire implements PinWire {
    private static final double MIDDLE = (FirmataPins.SHORTEST + FirmataPins.LONGEST) / 2.0;
    private static final double MICROS_A_DEGREE = (FirmataPins.LONGEST - FirmataPins.SHORTEST) / 180.0;

    private final ServoHardware servo;

    ServoWire(ServoHardware servo) {
        this.servo = servo;
    }

    @Override
    public void pulse(int micros) {
        if (micros > 0) {
            servo.setAngle(Math.max(servo.getMinAngle(),
                Math.min(servo.getMaxAngle(), (micros - MIDDLE) / MICROS_A_DEGREE)));
        }
    }

    @Override
    public String describe() {
        return servo.getName() + " (servo)";
    }
}
