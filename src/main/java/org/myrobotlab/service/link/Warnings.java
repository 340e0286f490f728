package org.myrobotlab.service.link;

import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;

/** Publishes warnings. MyRobotLab's own {@code Service.warn} makes errors of them: its {@code Status.warn(String)} does. Any thread. */
public final class Warnings {
    private Warnings() {
    }

    /**
     * Publishes a warning status of a service.
     *
     * @param format as of {@link String#format}
     */
    public static void publish(Service<?> service, String format, Object... args) {
        Status status = Status.warn(format, args);
        status.name = service.getName();
        service.broadcastStatus(status);
    }
}
