package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** Configuration of Roomba: its Serial is its own, {@code NAME.serial}, so that the name "serial" is left to scripts. */
public class RoombaConfig extends ServiceConfig {
    @Override
    public Plan getDefault(Plan plan, String name) {
        super.getDefault(plan, name);
        addDefaultPeerConfig(plan, name, "serial", "Serial");
        return plan;
    }
}
