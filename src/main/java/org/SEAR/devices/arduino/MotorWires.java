// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.devices.MotorHardware;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.WireRole;

/**
 * Wires of a motor's driver (H bridge) and encoder. The driver takes pulses for power and a level for direction, or
 * pulses for either direction. The encoder's second track follows the first by a quarter line when turning forward:
 * four counts per line.
 */
final class MotorWires {
    private static final int PHASES = 4;

    private final MotorHardware motor;
    private double forward;
    private double reverse;
    private boolean backwards;
    private double power;

    MotorWires(MotorHardware motor) {
        this.motor = motor;
    }

    /** Creates the wire with a role. */
    PinWire wire(WireRole role) {
        return role == WireRole.ENCODER_A || role == WireRole.ENCODER_B ? new Track(role) : new Power(role);
    }

    private void drive(WireRole role, double level) {
        if (role == WireRole.PWM) {
            forward = level;
        } else if (role == WireRole.REVERSE) {
            reverse = level;
        } else {
            backwards = level < 1;
        }
        double now = backwards ? -forward : forward - reverse;
        if (now != power) {
            power = now;
            motor.setPower(now);
        }
    }

    private String describe(WireRole role) {
        return motor.getName() + " (" + role.getWord() + ")";
    }

    private final class Power implements PinWire {
        private final WireRole role;

        Power(WireRole role) {
            this.role = role;
        }

        @Override
        public void drive(double level) {
            MotorWires.this.drive(role, level);
        }

        @Override
        public void pull(boolean up) {
            drive(up ? 1 : 0);
        }

        @Override
        public String describe() {
            return MotorWires.this.describe(role);
        }
    }

    private final class Track implements PinWire {
        private final WireRole role;

        Track(WireRole role) {
            this.role = role;
        }

        private MotorWires owner() {
            return MotorWires.this;
        }

        @Override
        public double volts() {
            return isHigh(motor.getCounts()) ? BoardModel.VOLTS : 0;
        }

        @Override
        public Encoder track() {
            return motor::getCounts;
        }

        @Override
        public boolean isHigh(long counts) {
            long phase = Math.floorMod(counts, (long) PHASES);
            return role == WireRole.ENCODER_A ? phase == 1 || phase == 2 : phase >= 2;
        }

        @Override
        public Encoder encoder(PinWire other) {
            if (!(other instanceof Track) || other == this || ((Track) other).owner() != owner()) {
                return null;
            }
            return role == WireRole.ENCODER_A ? motor::getCounts : () -> -motor.getCounts();
        }

        @Override
        public String describe() {
            return MotorWires.this.describe(role);
        }
    }
}
