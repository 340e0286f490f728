// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** Description of the Python3 service in MyRobotLab. */
public class Python3Meta extends MetaData {
    private static final long serialVersionUID = 1L;

    public Python3Meta() {
        addDescription("calls functions of a Python 3 program that uses the package sear");
        addCategory("programming");
        setLicenseApache();
    }
}
