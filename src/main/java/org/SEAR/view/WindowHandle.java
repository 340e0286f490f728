package org.SEAR.view;

/** What {@link SimulatorWindow} needs of the window behind it, without any jMonkeyEngine type. Any thread. */
interface WindowHandle {
    boolean isOpen();

    /** Why it never opened; null when it did. */
    String problem();

    /** Ends the window and waits until its thread has ended. */
    void close();
}
