package org.SEAR.devices.arduino;

/** A device that a service of MyRobotLab has attached to MrlComm. */
interface MrlDevice {
    /** Its kind, as MyRobotLab numbers them. */
    int type();

    /** What it does in each loop of the program. */
    void loop(double time);

    /** It is given up. */
    void detach();
}
