package org.myrobotlab.service.sear;

/** The service that a simulation belongs to. Any thread. */
public interface Host {
    /** The service's name, for callbacks. */
    String getName();

    /** The folder where MyRobotLab has its services' resources. */
    String getResourceRoot();

    /** How far something is that takes long. */
    void progress(String message);

    /** Something the user should know. */
    void warn(String message);

    /** Something that failed. */
    void error(String message);

    /** The user has closed the simulator window. */
    void windowClosed();

    /** Whether somebody listens to readings that are published. */
    default boolean isReadingHeard() {
        return false;
    }

    /** Publishes a reading. */
    void reading(SensorReading reading);

    /** Publishes the state of the world, if somebody listens. */
    void state();
}
