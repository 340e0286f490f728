package org.myrobotlab.service.config;

import org.myrobotlab.framework.Plan;

/** Configuration of Roomba: its Serial is the one that scripts know as "serial". */
public class RoombaConfig extends ServiceConfig {
    @Override
    public Plan getDefault(Plan plan, String name) {
        super.getDefault(plan, name);
        addDefaultGlobalConfig(plan, "serial", "serial", "Serial");
        return plan;
    }
}
