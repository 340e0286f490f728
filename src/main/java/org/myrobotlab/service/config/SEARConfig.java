package org.myrobotlab.service.config;

/** What a SEAR service remembers. The project's folder is {@code SEARproject} in MyRobotLab's working folder. */
public class SEARConfig extends ServiceConfig {
    /** Whether closing the simulator window stops the simulation; otherwise it goes on without a window. */
    public boolean closingWindowStops;
}
