// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Description of the GPS service in MyRobotLab. */
public class GPSMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public GPSMeta() {
        addDescription("reads a GPS receiver that sends NMEA sentences or UBX, real or simulated");
        addCategory("sensors");
        setLicenseApache();
    }
}
