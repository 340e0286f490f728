// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

/** Window behind {@link SimulatorWindow}, without jMonkeyEngine types. Any thread. */
interface WindowHandle {
    boolean isOpen();

    /** Returns why the window never opened, or null. */
    String problem();

    /** Closes the window and waits for the end of its thread. */
    void close();
}
