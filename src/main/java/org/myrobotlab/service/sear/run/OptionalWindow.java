// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.function.BooleanSupplier;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.view.SimulatorWindow;
import org.SEAR.view.WindowOptions;
import org.myrobotlab.service.sear.Host;

/** The simulator's window, if the system supports one. */
final class OptionalWindow {
    private AutoCloseable window;

    /** Opens the window. Without a display, OpenGL or its libraries, warns and opens none. */
    synchronized void open(SimulationRunner runner, boolean debugShapes, BooleanSupplier scriptDrives, Host host) {
        try {
            WindowOptions options = new WindowOptions().setDebugShapes(debugShapes).setScriptDrives(scriptDrives)
                .setWarnings(host::warn).setOnClosed(host::windowClosed);
            window = SimulatorWindow.open(runner, options);
        } catch (LinkageError | RuntimeException e) {
            host.warn("no simulator window: " + e + " (install jMonkeyEngine 3.6.1's jars into libraries/jar "
                + "to have one)");
        }
    }

    synchronized void close() {
        if (window != null) {
            try {
                window.close();
            } catch (Exception e) {
                throw new IllegalStateException("the simulator window did not close: " + e, e);
            }
            window = null;
        }
    }
}
