package org.SEAR.devices.arduino;

/** A device that a service of MyRobotLab has attached to MrlComm. */
interface MrlDevice {
    /** What it does in each loop of the program. */
    void loop(double time);

    /** It is given up. */
    void detach();
}
