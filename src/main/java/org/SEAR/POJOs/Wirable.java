// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;
import org.SEAR.protocol.arduino.WireRole;

/** A component that can be wired to the pins of an {@link Arduino}. */
public interface Wirable {
    /** Returns the possible roles of its wires; the first is the default. */
    List<WireRole> getWireRoles();
}
