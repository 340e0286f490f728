package org.myrobotlab.serial;

import java.util.List;

/** Knows the serial ports of this machine. */
public interface SerialControl {
    /** Their names. */
    List<String> getPortNames();
}
