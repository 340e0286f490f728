// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.IOException;

/** A picture that is harmless but can't be shown. */
public final class UnreadablePicture extends IOException {
    private static final long serialVersionUID = 1L;

    /** @param message the file, the problem and legal values */
    public UnreadablePicture(String message, Exception cause) {
        super(message, cause);
    }
}
