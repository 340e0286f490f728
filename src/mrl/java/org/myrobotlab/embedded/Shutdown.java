package org.myrobotlab.embedded;

/** What ends the program when a script or a user shuts MyRobotLab down. */
public final class Shutdown {
    private static volatile Runnable action = () -> { };

    private Shutdown() {
    }

    /** Sets what is done after everything was released; nothing unless set. */
    public static void then(Runnable newAction) {
        action = newAction;
    }

    /** Does it. */
    public static void run() {
        action.run();
    }
}
