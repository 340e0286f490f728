// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.arduino.WireRole;

/** A wire from a pin of an {@link Arduino} to a component of the same robot. Immutable, any thread. */
@Described("a wire from a pin of an Arduino to a component of the same robot")
public class BoardWire {
    @Param(doc = "the pin, 7 or A0", required = true)
    private String pin;
    @Param(doc = "name of the component", text = TextRule.NAME, names = SearObject.class, required = true)
    private String part;
    @Param(doc = "role of the wire",
        values = {"volts", "ping", "trigger", "echo", "pwm", "reverse", "direction", "encoderA", "encoderB",
            "servo", "switch", "light"},
        required = true)
    private String role;

    /** For reading from a file. */
    protected BoardWire() {
    }

    BoardWire(String pin, String part, WireRole role) {
        this.pin = pin;
        this.part = part;
        this.role = role.getWord();
    }

    /** Returns the pin as printed on the board, {@code 7} or {@code A0}. */
    public String getPin() {
        return pin;
    }

    public String getPart() {
        return part;
    }

    /** Returns the role of the wire; null only in a file that is being checked. */
    public WireRole getRole() {
        return WireRole.of(role);
    }
}
