package org.myrobotlab.service.meta;

import org.myrobotlab.service.meta.abstracts.MetaData;

/** What MyRobotLab shows about the Python3 service. */
public class Python3Meta extends MetaData {
    private static final long serialVersionUID = 1L;

    /** As MyRobotLab makes it. */
    public Python3Meta() {
        addDescription("calls functions of a Python 3 program that uses the package sear");
        addCategory("programming");
        setLicenseApache();
    }
}
