// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.ServiceConfig;

/** A service that runs out of memory in its method. */
public class Hungry extends Service<ServiceConfig> {
    private static final long serialVersionUID = 1L;

    /** Signature that MyRobotLab requires. */
    public Hungry(String name, String id) {
        super(name, id);
    }

    /** Never returns. */
    public void eat() {
        throw new OutOfMemoryError("Java heap space");
    }
}
