package org.SEAR.POJOs;

import java.util.List;
import org.SEAR.protocol.arduino.WireRole;

/** A component that can be wired to the pins of an {@link Arduino}. */
public interface Wirable {
    /** What its wires may be for; the first is meant where nothing is said. */
    List<WireRole> getWireRoles();
}
