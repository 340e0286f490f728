// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** Configuration of Roomba. Its peer {@code NAME.serial} starts with it, but is not used, as in the real MyRobotLab. */
public class RoombaConfig extends ServiceConfig {
    @Override
    public Plan getDefault(Plan plan, String name) {
        super.getDefault(plan, name);
        addDefaultPeerConfig(plan, name, "serial", "Serial");
        return plan;
    }
}
