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

    /** Whether somebody listens to pictures that are published. */
    default boolean isImageHeard() {
        return false;
    }

    /**
     * Publishes a camera's picture.
     *
     * @param camera its name
     * @param png a PNG file
     */
    default void image(String camera, byte[] png) {
    }

    /** Publishes a reading. */
    void reading(SensorReading reading);

    /** Publishes the state of the world, if somebody listens. */
    void state();
}
