// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

/** Thrown when the answer to a message is late. */
public class TimeoutException extends Exception {
    private static final long serialVersionUID = 1L;

    public TimeoutException(String format, Object... args) {
        super(String.format(format, args));
    }
}
