// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** Saved configuration of a LIDAR service. */
public class LIDARConfig extends ServiceConfig {
    /** Port of the last connection; null before the first. */
    public String port;
    /** A baud rate of the model. LMS200: 9600 (default), 19200, 38400 or 500000. */
    public int baud = 9600;
    /** LMS200 (default), LMS211, LMS220, LMS221, LMS291, URG-04LX, UTM-30LX or RPLIDAR-A1. */
    public String model = "LMS200";
    /** Unit of the raw values: mm or cm; null (default): the device's own setting. */
    public String unit;

    @Override
    public Plan getDefault(Plan plan, String name) {
        super.getDefault(plan, name);
        addDefaultPeerConfig(plan, name, "serial", "Serial");
        return plan;
    }
}
