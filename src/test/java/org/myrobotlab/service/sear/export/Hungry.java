package org.myrobotlab.service.sear.export;

import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.ServiceConfig;

/** A service that has no memory for what it is asked to do. */
public class Hungry extends Service<ServiceConfig> {
    private static final long serialVersionUID = 1L;

    /** As MyRobotLab makes services. */
    public Hungry(String name, String id) {
        super(name, id);
    }

    /** Never returns. */
    public void eat() {
        throw new OutOfMemoryError("Java heap space");
    }
}
