package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** What a GPS service remembers. */
public class GPSConfig extends ServiceConfig {
    /** The port last connected to; null before the first time. */
    public String port;
    /** Bits a second: 4800 to 115200, of a NEO-M8N to 921600; default 38400. */
    public int baud = 38400;
    /** FV-M8 (default), MT3301, MT3329, NEO-M8N or NMEA. */
    public String model = "FV-M8";

    @Override
    public Plan getDefault(Plan plan, String name) {
        super.getDefault(plan, name);
        addDefaultPeerConfig(plan, name, "serial", "Serial");
        return plan;
    }
}
