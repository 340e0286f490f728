package org.SEAR.devices.arduino;

import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.BoardWire;
import org.SEAR.devices.DeviceContext;
import org.SEAR.sensors.Sensor;

/** Hangs the components that an {@link Arduino} names on its pins. */
final class Wiring {
    private final DeviceContext context;

    Wiring(DeviceContext context) {
        this.context = context;
    }

    void connect(Arduino board, Pins pins) {
        for (BoardWire wire : board.getWires()) {
            PinWire end = end(wire);
            if (end == null) {
                context.warn("pin " + wire.getPin() + ": " + wire.getPart() + " is not on its robot");
            } else {
                pins.connect(board.getModel().pinOf(wire.getPin()), end);
            }
        }
    }

    private PinWire end(BoardWire wire) {
        switch (wire.getRole()) {
            case VOLTS:
            case PING:
            case TRIGGER:
            case ECHO:
                Sensor<?> sensor = context.sensor(wire.getPart());
                return sensor == null ? null : new RangeWire(context, sensor, wire.getRole());
            default:
                return null;
        }
    }
}
