package org.SEAR.protocol.cola;

/** A request that can't be carried out as it is. */
public final class ColaException extends Exception {
    private static final long serialVersionUID = 1L;

    private final ColaError error;

    public ColaException(ColaError error) {
        super(error.toString());
        this.error = error;
    }

    /** Why. */
    public ColaError getError() {
        return error;
    }
}
