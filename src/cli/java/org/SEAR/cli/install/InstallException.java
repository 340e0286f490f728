package org.SEAR.cli.install;

/** Why nothing was installed or removed, and what to do about it. */
public final class InstallException extends Exception {
    private static final long serialVersionUID = 1L;

    InstallException(String message) {
        super(message);
    }
}
