// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear;

import java.nio.file.Path;

/** The service that owns a simulation. Any thread. */
public interface Host {
    String getName();

    /** Returns the folder of MyRobotLab's service resources. */
    String getResourceRoot();

    /** Reports the progress of a long operation. */
    void progress(String message);

    void warn(String message);

    void error(String message);

    /** Called when the user has closed the simulator window. */
    void windowClosed();

    /** Returns the number of calls of the service so far. */
    default long queries() {
        return 0;
    }

    /** Returns whether published readings have a subscriber. */
    default boolean isReadingHeard() {
        return false;
    }

    /** Returns whether published pictures have a subscriber. */
    default boolean isImageHeard() {
        return false;
    }

    /**
     * Publishes a camera's picture.
     *
     * @param png a PNG file
     */
    default void image(String camera, byte[] png) {
    }

    void reading(SensorReading reading);

    /**
     * Publishes that another project has replaced the user's, which became a backup.
     *
     * @param words its contents
     */
    default void kept(Path backup, String words) {
    }

    /** Publishes the state of the world if it has a subscriber. */
    void state();
}
