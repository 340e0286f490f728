// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

/** Severity of a {@link Status}. */
public class StatusLevel {
    public static final String DEBUG = "debug";
    public static final String INFO = "info";
    public static final String WARN = "warn";
    public static final String ERROR = "error";
    public static final String SUCCESS = "success";
}
