// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Description of the LIDAR service in MyRobotLab. */
public class LIDARMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public LIDARMeta() {
        addDescription("drives a laser scanner, real or simulated: SICK LMS200, Hokuyo URG-04LX and UTM-30LX, "
            + "Slamtec RPLIDAR A1");
        addCategory("sensors");
        setLicenseApache();
    }
}
