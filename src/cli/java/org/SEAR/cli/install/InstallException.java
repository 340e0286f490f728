// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

/** Explains why nothing was installed or removed, and what to do. */
public final class InstallException extends Exception {
    private static final long serialVersionUID = 1L;

    InstallException(String message) {
        super(message);
    }
}
