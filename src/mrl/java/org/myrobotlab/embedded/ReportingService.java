package org.myrobotlab.embedded;

import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.framework.Status;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.interfaces.QueueReporter;
import org.slf4j.Logger;

/** What a service tells about itself: statuses, its last error. */
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

    /** A text of several lines, as a traceback, begins on a line of its own; with the line of the script that has called, if one has. */
    private static String spaced(Status status) {
        return (status.key.indexOf('\n') < 0 ? " " : System.lineSeparator()) + status.key + (status.isInfo() ? "" : ScriptPlace.here());
    }

    /** Only what is published by these methods stands in the log, too, as in the real one: who broadcasts a status himself, logs it himself. */
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

    /** Publishes an error, as in the real one: {@code broadcastStatus(Status.warn(format, args))} is what publishes a warning. */
    public Status warn(String text) {
        return broadcasted(Status.warn(text));
    }

    /** The same with a format. */
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

    /** Where errors are published. */
    public Status publishError(Status status) {
        return status;
    }

    /** Where warnings are published. */
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
