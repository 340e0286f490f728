// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

/** Ends the program when a script or a user shuts MyRobotLab down. */
public final class Shutdown {
    private static volatile Runnable action = () -> { };

    private Shutdown() {
    }

    /** Sets the action that follows the release of all services; none by default. */
    public static void then(Runnable newAction) {
        action = newAction;
    }

    /** Runs the action. */
    public static void run() {
        action.run();
    }
}
