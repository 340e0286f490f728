// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.IOException;

/** A file with an invalid value. The message names the file, the place, the value and the legal values. */
public final class InvalidFile extends IOException {
    private static final long serialVersionUID = 1L;

    InvalidFile(String message, Exception cause) {
        super(message, cause);
    }
}
