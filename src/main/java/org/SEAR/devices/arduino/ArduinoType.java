// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;

/** Creates the board of an {@link Arduino}, with its program and wiring. */
public final class ArduinoType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return Arduino.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        Arduino arduino = (Arduino) parameters;
        Pins pins = new Pins(arduino.getModel(), arduino.getFullName(), context);
        new Wiring(context).connect(arduino, pins);
        return new ArduinoBoard(arduino.getModel().getTitle() + ", " + arduino.getFirmware(), arduino.getBaud(),
            pins, context, arduino.isFirmata() ? FirmataFirmware::new : MrlCommFirmware::new);
    }
}
