// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Description of the SEAR service in MyRobotLab. */
public class SEARMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public SEARMeta() {
        addDescription("simulates robots, their sensors and their serial devices");
        addCategory("simulator");
        setLicenseApache();
    }
}
