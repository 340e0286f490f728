// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Meta data of Serial. */
public class SerialMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public SerialMeta() {
        addDescription("reads from and writes to serial ports");
        addCategory("sensors", "control");
    }
}
