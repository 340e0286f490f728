package org.SEAR.files;

import java.io.IOException;

/** A picture that does no harm but can't be shown. */
public final class UnreadablePicture extends IOException {
    private static final long serialVersionUID = 1L;

    /** @param message names the file, what is wrong with it and what is legal */
    public UnreadablePicture(String message, Exception cause) {
        super(message, cause);
    }
}
