package org.myrobotlab.serial;

/** A service that is to be connected again. Immutable; any thread. */
public final class PortUser {
    final String name;
    final String port;
    final boolean ofThisProject;
    final Runnable connect;
    final Runnable leave;

    /**
     * @param name of the service
     * @param ofThisProject whether it waits for the device that it had, which doesn't come back when another project is opened
     * @param connect opens the port; run on the thread that brings it
     * @param leave closes the port if the service still has it
     */
    public PortUser(String name, String port, boolean ofThisProject, Runnable connect, Runnable leave) {
        this.name = name;
        this.port = port;
        this.ofThisProject = ofThisProject;
        this.connect = connect;
        this.leave = leave;
    }
}
