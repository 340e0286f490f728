// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Locale;
import java.util.Map;

/** Names of registers that are not simulated. Source: register summary in the data sheet. */
final class RegisterNames {
    private static final Map<Integer, String> NAMES = Map.ofEntries(Map.entry(0x4C, "SPCR"), Map.entry(0x4D, "SPSR"),
        Map.entry(0x4E, "SPDR"), Map.entry(0xB6, "ASSR"), Map.entry(0xB8, "TWBR"), Map.entry(0xB9, "TWSR"),
        Map.entry(0xBA, "TWAR"), Map.entry(0xBB, "TWDR"), Map.entry(0xBC, "TWCR"), Map.entry(0xBD, "TWAMR"),
        Map.entry(0x50, "ACSR"), Map.entry(0x57, "SPMCSR"));

    private RegisterNames() {
    }

    static String of(int address) {
        String name = NAMES.get(address);
        return String.format(Locale.ROOT, name == null ? "the register at 0x%02X" : "register " + name + " (0x%02X)",
            address);
    }
}
