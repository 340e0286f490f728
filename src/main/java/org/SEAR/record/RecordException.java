// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.IOException;

/** A file that is not a record, or a record with impossible values. */
public final class RecordException extends IOException {
    private static final long serialVersionUID = 1L;

    RecordException(String message) {
        super(message);
    }
}
