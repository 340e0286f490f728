// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.framework.Status;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.interfaces.QueueReporter;
import org.slf4j.Logger;

/** Statuses of a service and its last error. */
public abstract class ReportingService extends MessagedService implements QueueReporter {
    private static final Logger LOG = LoggerFactory.getLogger(ReportingService.class);

    protected Status lastError;
    protected Long lastErrorTs;
    protected Status lastStatus;
    protected Long lastStatusTs;

    protected ReportingService(String name, String id) {
        super(name, id);
    }

    @Override
    public void broadcastStatus(Status status) {
        if (status.name == null) {
            status.name = getName();
        }
        lastStatus = status;
        lastStatusTs = System.currentTimeMillis();
        if (status.isError()) {
            lastError = status;
            lastErrorTs = lastStatusTs;
            invoke("publishError", status);
        } else if (status.isWarn()) {
            invoke("publishWarn", status);
        }
        invoke("publishStatus", status);
    }

    /**
     * Returns the text for the log, with the line of the calling script, if any. A text of several lines, such as a
     * traceback, starts on a new line.
     */
    private static String spaced(Status status) {
        return (status.key.indexOf('\n') < 0 ? " " : System.lineSeparator()) + status.key
            + (status.isInfo() ? "" : ScriptPlace.here());
    }

    /** Logs and broadcasts a status. {@code broadcastStatus} alone does not log, as in the real MyRobotLab. */
    private Status broadcasted(Status status) {
        if (status.isError()) {
            LOG.error("{}:{}", getName(), spaced(status));
        } else if (status.isWarn()) {
            LOG.warn("{}:{}", getName(), spaced(status));
        } else {
            LOG.info("{}:{}", getName(), spaced(status));
        }
        broadcastStatus(status);
        return status;
    }

    @Override
    final void complain(String text, String method, String reason) {
        if (lastError == null || !reason.equals(lastError.key)) {
            LOG.error("{}.{}: {}", getName(), method, reason);
        }
        broadcastStatus(Status.error(text));
    }

    @Override
    public Status error(Exception e) {
        LOG.debug("{}", getName(), e);
        return broadcasted(Status.error(e));
    }

    public Status error(String text) {
        return broadcasted(Status.error(text));
    }

    @Override
    public Status error(String format, Object... args) {
        return broadcasted(Status.error(format, args));
    }

    /**
     * Publishes an error, as in the real MyRobotLab; {@code broadcastStatus(Status.warn(format, args))} publishes a
     * warning.
     */
    public Status warn(String text) {
        return broadcasted(Status.warn(text));
    }

    /** Publishes an error, with a format. */
    @Override
    public Status warn(String format, Object... args) {
        return warn(String.format(format, args));
    }

    public Status info(String text) {
        return broadcasted(Status.info(text));
    }

    @Override
    public Status info(String format, Object... args) {
        return broadcasted(Status.info(format, args));
    }

    /** Publishes errors. */
    public Status publishError(Status status) {
        return status;
    }

    /** Publishes warnings. */
    public Status publishWarn(Status status) {
        return status;
    }

    @Override
    public Status publishStatus(Status status) {
        return status;
    }

    @Override
    public Status getLastError() {
        return lastError;
    }

    @Override
    public boolean hasError() {
        return lastError != null;
    }

    @Override
    public String clearLastError() {
        String text = lastError == null ? null : lastError.toString();
        lastError = null;
        return text;
    }

    @Override
    public QueueStats publishStats(QueueStats stats) {
        return stats;
    }

    @Override
    public void updateStats(QueueStats stats) {
        invoke("publishStats", stats);
    }
}
