// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

/** Dimensions that drivers assume for a robot with an Open Interface. Immutable, any thread. */
public enum OpenInterfaceBody {
    /** Roomba 400 (SCI) and 500: distances are in millimetres, so drivers do not depend on the size of the wheels. */
    ROOMBA_400("roomba400", 0.258, 0.036),
    /** Create 1. */
    CREATE("create", 0.258, 0.036),
    /** Create 2 and Roomba 600: 508.8 encoder counts per turn of a 72 mm wheel. */
    CREATE_2("create2", 0.235, 0.036);

    /** As in {@link Dynamics#getModel}. */
    public final String model;
    /** Distance between the middles of the left and the right wheel, metres. */
    public final double track;
    /** Metres; from the Create 2's document, also for the other models. */
    public final double wheelRadius;

    OpenInterfaceBody(String model, double track, double wheelRadius) {
        this.model = model;
        this.track = track;
        this.wheelRadius = wheelRadius;
    }

    /** Returns whether drivers count turns of the wheels, so that the wheels' radius matters. */
    public boolean hasEncoders() {
        return this == CREATE_2;
    }

    /**
     * Returns the body of a model.
     *
     * @param model legal for {@link Dynamics#setModel}
     */
    public static OpenInterfaceBody of(String model) {
        for (OpenInterfaceBody body : values()) {
            if (body.model.equals(model)) {
                return body;
            }
        }
        throw new IllegalArgumentException("model is \"" + model + "\", legal: roomba400, create, create2");
    }
}
