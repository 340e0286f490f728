package org.SEAR.record;

import java.io.IOException;

/** A file that is no record, or one that says what can't be. */
public final class RecordException extends IOException {
    private static final long serialVersionUID = 1L;

    RecordException(String message) {
        super(message);
    }
}
