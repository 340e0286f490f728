// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.cola;

/** A request that a scanner answers with an error. */
public final class ColaException extends Exception {
    private static final long serialVersionUID = 1L;

    private final ColaError error;

    public ColaException(ColaError error) {
        super(error.toString());
        this.error = error;
    }

    public ColaError getError() {
        return error;
    }
}
