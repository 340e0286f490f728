package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** What MyRobotLab shows about the LIDAR service. */
public class LIDARMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    /** As MyRobotLab makes it. */
    public LIDARMeta() {
        addDescription("drives a SICK LMS200 laser scanner, real or simulated");
        addCategory("sensors");
        setLicenseApache();
    }
}
