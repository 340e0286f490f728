// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.devices.FakeContext;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.arduino.BoardModel;

/** Boards for tests of other packages. */
public final class Devices {
    private Devices() {
    }

    /** Returns an Uno with nothing wired to it. */
    public static SerialDevice uno(boolean firmata, FakeContext line) {
        return new ArduinoBoard("Uno", firmata ? 57600 : 115200, new Pins(BoardModel.UNO, "uno", line), line,
            firmata ? FirmataFirmware::new : MrlCommFirmware::new);
    }
}
