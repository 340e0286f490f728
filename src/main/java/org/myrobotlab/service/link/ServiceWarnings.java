package org.myrobotlab.service.link;

import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Publishes and logs warnings. MyRobotLab's own {@code Service.warn} makes errors of them: its {@code Status.warn(String)} does. Any thread.
 */
public final class ServiceWarnings {
    private static final Logger log = LoggerFactory.getLogger(ServiceWarnings.class);

    private ServiceWarnings() {
    }

    /**
     * Publishes a warning status of a service, with the script's line if one is calling, and writes it to the log.
     *
     * @param format as of {@link String#format}
     */
    public static void publish(Service<?> service, String format, Object... args) {
        Status status = Status.warn("%s", ScriptLine.added(String.format(format, args), ScriptLine.here()));
        status.name = service.getName();
        log.warn("{}: {}", status.name, status.detail);
        service.broadcastStatus(status);
    }
}
