package org.myrobotlab.framework;

/** The answer to a message did not come in time. */
public class TimeoutException extends Exception {
    private static final long serialVersionUID = 1L;

    public TimeoutException(String format, Object... args) {
        super(String.format(format, args));
    }
}
