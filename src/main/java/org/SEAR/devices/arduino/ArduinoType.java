// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.arduino.ProgramFile;

/** Creates the board of an {@link Arduino}, with its program and wiring. */
public final class ArduinoType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return Arduino.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        Arduino arduino = (Arduino) parameters;
        return arduino.getSketch() != null ? sketch(arduino, context) : firmware(arduino, context);
    }

    private static SerialDevice firmware(Arduino arduino, DeviceContext context) {
        Pins pins = new Pins(arduino.getModel(), arduino.getFullName(), context);
        new Wiring(context).connect(arduino, (wire, pin) -> pins.connect(pin, wire));
        return new ArduinoBoard(arduino.getModel().getTitle() + ", " + arduino.getFirmware(), arduino.getBaud(),
            pins, context, arduino.isFirmata() ? FirmataFirmware::new : MrlCommFirmware::new);
    }

    private static SerialDevice sketch(Arduino arduino, DeviceContext context) {
        SketchPins pins = new SketchPins(arduino.getModel(), arduino.getFullName(), context);
        new Wiring(context).connect(arduino, (wire, pin) -> pins.connect(pin, wire));
        try {
            byte[] program = ProgramFile.read(context.asset(arduino.getSketch()), arduino.getModel().getFlash());
            String file = arduino.getSketch().substring(arduino.getSketch().lastIndexOf('/') + 1);
            return new SketchBoard(arduino.getModel().getTitle() + ", " + file, arduino.getBaud(), program, pins,
                context);
        } catch (IOException e) {
            throw new UncheckedIOException(arduino + ": " + e.getMessage(), e);
        }
    }
}
