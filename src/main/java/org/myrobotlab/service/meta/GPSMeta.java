package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** What MyRobotLab shows about the GPS service. */
public class GPSMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    /** As MyRobotLab makes it. */
    public GPSMeta() {
        addDescription("reads a GPS receiver that sends NMEA sentences or UBX, real or simulated");
        addCategory("sensors");
        setLicenseApache();
    }
}
