// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.PrintWriter;
import java.io.Serializable;
import java.io.StringWriter;
import java.util.Objects;

/** A notice, warning or error of a service. */
public class Status implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The service that reports it. */
    public String name;
    /** One of {@link StatusLevel}. */
    public String level;
    /** Short text. */
    public String key;
    /** Full text. */
    public String detail;
    /** Cause, if known. */
    public transient Object source;

    public Status(Exception e) {
        this(null, StatusLevel.ERROR, e.getClass().getSimpleName()
            + (e.getMessage() == null ? "" : ": " + e.getMessage()), stackToString(e));
        source = e;
    }

    public Status(Status other) {
        this(other.name, other.level, other.key, other.detail);
        source = other.source;
    }

    public Status(String detail) {
        this(null, StatusLevel.INFO, detail, detail);
    }

    public Status(String name, String level, String key, String detail) {
        this.name = name;
        this.level = level;
        this.key = key;
        this.detail = detail;
    }

    public static final Status newInstance(String name, String level, String key, String detail) {
        return new Status(name, level, key, detail);
    }

    public static Status debug(String format, Object... args) {
        return of(StatusLevel.DEBUG, String.format(format, args));
    }

    public static Status info(String text) {
        return of(StatusLevel.INFO, text);
    }

    public static Status info(String format, Object... args) {
        return of(StatusLevel.INFO, String.format(format, args));
    }

    /** Returns an error, as in the real MyRobotLab; the method with a format returns a warning. */
    public static Status warn(String text) {
        return of(StatusLevel.ERROR, text);
    }

    public static Status warn(String format, Object... args) {
        return of(StatusLevel.WARN, String.format(format, args));
    }

    public static Status error(String text) {
        return of(StatusLevel.ERROR, text);
    }

    public static Status error(String format, Object... args) {
        return of(StatusLevel.ERROR, String.format(format, args));
    }

    public static Status error(Exception e) {
        return new Status(e);
    }

    public static Status success() {
        return success("success");
    }

    public static Status success(String text) {
        return of(StatusLevel.SUCCESS, text);
    }

    private static Status of(String level, String text) {
        return new Status(null, level, text, text);
    }

    public static final String stackToString(Throwable e) {
        StringWriter text = new StringWriter();
        try (PrintWriter writer = new PrintWriter(text)) {
            for (Throwable at = e; at != null; at = at.getCause()) {
                writer.println((at == e ? "" : "Caused by: ") + at);
                for (StackTraceElement element : at.getStackTrace()) {
                    writer.println("\tat " + element);
                }
            }
        }
        return text.toString();
    }

    public boolean isDebug() {
        return StatusLevel.DEBUG.equals(level);
    }

    public boolean isInfo() {
        return StatusLevel.INFO.equals(level);
    }

    public boolean isWarn() {
        return StatusLevel.WARN.equals(level);
    }

    public boolean isError() {
        return StatusLevel.ERROR.equals(level);
    }

    public boolean isSuccess() {
        return StatusLevel.SUCCESS.equals(level);
    }

    @Override
    public boolean equals(Object other) {
        if (!(other instanceof Status)) {
            return false;
        }
        Status that = (Status) other;
        return Objects.equals(name, that.name) && Objects.equals(level, that.level) && Objects.equals(key, that.key)
            && Objects.equals(detail, that.detail);
    }

    @Override
    public int hashCode() {
        return Objects.hash(name, level, key, detail);
    }

    @Override
    public String toString() {
        return (name == null ? "" : name + " ") + level + " " + key;
    }
}
