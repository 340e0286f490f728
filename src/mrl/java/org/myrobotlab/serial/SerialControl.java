// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.util.List;

/** Lists the serial ports of this computer. */
public interface SerialControl {
    /** Names of the ports. */
    List<String> getPortNames();
}
