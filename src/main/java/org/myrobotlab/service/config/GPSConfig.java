// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** Saved configuration of a GPS service. */
public class GPSConfig extends ServiceConfig {
    /** Port of the last connection; null before the first. */
    public String port;
    /** Baud rate: 4800 to 115200, NEO-M8N up to 921600; default 38400. */
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
