package org.SEAR.POJOs;

/** What the drivers of a robot with an Open Interface take for its dimensions. Immutable, any thread. */
public enum OpenInterfaceBody {
    /** Roomba 400 (SCI) and 500: distances come in millimetres, so the wheels' size is the robot's own affair. */
    ROOMBA_400("roomba400", 0.258, 0.036),
    /** Create 1. */
    CREATE("create", 0.258, 0.036),
    /** Create 2 and Roomba 600: encoders count 508.8 a turn of a wheel of 72 mm. */
    CREATE_2("create2", 0.235, 0.036);

    /** As in {@link Dynamics#getModel}. */
    public final String model;
    /** Metres from the middle of the left wheel to that of the right one. */
    public final double wheelBase;
    /** Metres; for the Create 2 by its document, for the others taken from there. */
    public final double wheelRadius;

    OpenInterfaceBody(String model, double wheelBase, double wheelRadius) {
        this.model = model;
        this.wheelBase = wheelBase;
        this.wheelRadius = wheelRadius;
    }

    /** Whether drivers count turns of the wheels, so that the wheels' radius matters to them. */
    public boolean hasEncoders() {
        return this == CREATE_2;
    }

    /**
     * That of a model.
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
