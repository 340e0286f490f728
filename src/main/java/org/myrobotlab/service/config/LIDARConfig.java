package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** What a LIDAR service remembers. */
public class LIDARConfig extends ServiceConfig {
    /** The port last connected to; null before the first time. */
    public String port;
    /** Bits a second, one that the model has: of an LMS200 9600 (default), 19200, 38400 or 500000. */
    public int baud = 9600;
    /** LMS200 (default), LMS211, LMS220, LMS221, LMS291, URG-04LX, UTM-30LX or RPLIDAR-A1. */
    public String model = "LMS200";
    /** mm or cm, as the device is to measure; null (default): as it does. */
    public String unit;

    @Override
    public Plan getDefault(Plan plan, String name) {
        super.getDefault(plan, name);
        addDefaultPeerConfig(plan, name, "serial", "Serial");
        return plan;
    }
}
