// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.devices.DeviceContext;
import org.SEAR.protocol.arduino.WireRole;
import org.SEAR.sensors.Sensor;

/**
 * A wire of a sensor: its voltage, a pulse as long as the sound travels, or a switch that connects the pin to ground.
 */
final class SensorWire implements PinWire {
    /** Pulse lengths without an echo, seconds. Source: data sheets of the PING))) and the HC-SR04. */
    static final double PING_SILENCE = 0.0185;
    static final double HC_SILENCE = 0.038;

    private final DeviceContext context;
    private final Sensor<?> sensor;
    private final WireRole role;

    SensorWire(DeviceContext context, Sensor<?> sensor, WireRole role) {
        this.context = context;
        this.sensor = sensor;
        this.role = role;
    }

    @Override
    public double volts() {
        switch (role) {
            case VOLTS:
            case SWITCH:
                return context.read(sensor).volts();
            case ECHO:
                return 0;
            default:
                return Double.NaN;
        }
    }

    @Override
    public double echo(PinWire listened) {
        if (!triggers(listened)) {
            return Double.NaN;
        }
        double silence = role == WireRole.PING ? PING_SILENCE : HC_SILENCE;
        return Math.min(silence, context.read(sensor).echo());
    }

    @Override
    public boolean triggers(PinWire listened) {
        return role == WireRole.PING && listened == this || role == WireRole.TRIGGER
            && listened instanceof SensorWire
            && ((SensorWire) listened).sensor == sensor && ((SensorWire) listened).role == WireRole.ECHO;
    }

    @Override
    public String describe() {
        return sensor.getName() + " (" + role.getWord() + ")";
    }
}
