package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** Configuration of Roomba. Its Serial is called {@code NAME.serial}, so that scripts can use the name "serial". */
public class RoombaConfig extends ServiceConfig {
    @Override
    public Plan getDefault(Plan plan, String name) {
        super.getDefault(plan, name);
        addDefaultPeerConfig(plan, name, "serial", "Serial");
        return plan;
    }
}
