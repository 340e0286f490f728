// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Publishes and logs warnings. MyRobotLab's {@code Service.warn} can't: its {@code Status.warn(String)} creates errors.
 * Any thread.
 */
public final class ServiceWarnings {
    private static final Logger log = LoggerFactory.getLogger(ServiceWarnings.class);

    private ServiceWarnings() {
    }

    /**
     * Publishes and logs a warning of a service. Adds the script's line if a script is calling.
     *
     * @param format as in {@link String#format}
     */
    public static void publish(Service<?> service, String format, Object... args) {
        Status status = Status.warn("%s", ScriptLine.added(String.format(format, args), ScriptLine.here()));
        status.name = service.getName();
        log.warn("{}: {}", status.name, status.detail);
        service.broadcastStatus(status);
    }
}
