// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.HashMap;
import java.util.Map;
import java.util.function.ObjIntConsumer;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.BoardWire;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.LightHardware;
import org.SEAR.devices.MotorHardware;
import org.SEAR.devices.ServoHardware;
import org.SEAR.sensors.Sensor;

/** Connects the components that an {@link Arduino} names to its pins. */
final class Wiring {
    private final DeviceContext context;
    private final Map<String, MotorWires> motors = new HashMap<>();

    Wiring(DeviceContext context) {
        this.context = context;
    }

    /** @param pins gets each wire with its pin */
    void connect(Arduino board, ObjIntConsumer<PinWire> pins) {
        for (BoardWire wire : board.getWires()) {
            PinWire end = end(wire);
            if (end == null) {
                context.warn("pin " + wire.getPin() + ": " + wire.getPart() + " is not on its robot");
            } else {
                pins.accept(end, board.getModel().pinOf(wire.getPin()));
            }
        }
    }

    private PinWire end(BoardWire wire) {
        switch (wire.getRole()) {
            case VOLTS:
            case PING:
            case TRIGGER:
            case ECHO:
            case SWITCH:
                Sensor<?> sensor = context.sensor(wire.getPart());
                return sensor == null ? null : new SensorWire(context, sensor, wire.getRole());
            case SERVO:
                ServoHardware servo = context.robot().getServo(wire.getPart());
                return servo == null ? null : new ServoWire(servo);
            case LIGHT:
                LightHardware light = context.robot().getLight(wire.getPart());
                return light == null ? null : new LightWire(light);
            default:
                MotorHardware motor = context.robot().getMotor(wire.getPart());
                return motor == null ? null : motors.computeIfAbsent(wire.getPart(), name -> new MotorWires(motor))
                    .wire(wire.getRole());
        }
    }

    /** A light between a pin and ground; its brightness is the mean level of the pin. */
    private static final class LightWire implements PinWire {
        private final LightHardware light;

        LightWire(LightHardware light) {
            this.light = light;
        }

        @Override
        public void drive(double level) {
            light.setBrightness(Double.isNaN(level) ? 0 : level);
        }

        @Override
        public String describe() {
            return light.getName() + " (light)";
        }
    }
}
