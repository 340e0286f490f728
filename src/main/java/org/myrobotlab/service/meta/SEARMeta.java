package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** What MyRobotLab shows about the SEAR service. */
public class SEARMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    /** As MyRobotLab makes it. */
    public SEARMeta() {
        addDescription("simulates robots, their sensors and their serial devices");
        addCategory("simulator");
        setLicenseApache();
    }
}
