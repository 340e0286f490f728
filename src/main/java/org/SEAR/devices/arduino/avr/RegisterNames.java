// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Locale;
import java.util.Map;

/** Names of registers that are not simulated. Source: register summary in the data sheet. */
final class RegisterNames {
    private static final Map<Integer, String> NAMES = Map.of(0x50, "ACSR", 0x57, "SPMCSR", 0xB6, "ASSR");

    private RegisterNames() {
    }

    static String of(int address) {
        String name = NAMES.get(address);
        return String.format(Locale.ROOT, name == null ? "the register at 0x%02X" : "register " + name + " (0x%02X)",
            address);
    }
}
