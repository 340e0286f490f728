// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

/** An action for the end of this program, unless it is cancelled before. Any thread. */
public final class ExitHook {
    private final Thread thread;

    /** @param action runs on its own thread while this program ends, also by a signal */
    public ExitHook(Runnable action) {
        thread = new Thread(action, "end of the program");
        Runtime.getRuntime().addShutdownHook(thread);
    }

    /** Cancels the action, unless it runs already. */
    public void cancel() {
        try {
            Runtime.getRuntime().removeShutdownHook(thread);
        } catch (IllegalStateException e) {
            return;     // this program is ending
        }
    }
}
