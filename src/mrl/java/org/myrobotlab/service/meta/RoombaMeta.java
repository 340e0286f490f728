// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Meta data of Roomba. */
public class RoombaMeta extends MetaData {
    private static final long serialVersionUID = 1L;

    public RoombaMeta() {
        addDescription("drives an iRobot Roomba or Create");
        addCategory("robot", "control");
    }
}
