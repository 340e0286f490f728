// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

/** A service that waits for reconnection. Immutable; any thread. */
public final class PortUser {
    final String name;
    final String port;
    final boolean ofThisProject;
    final Runnable connect;
    final Runnable leave;

    /**
     * @param name of the service
     * @param ofThisProject whether it waits for a device of the open project, which another project does not have
     * @param connect opens the port; runs on the thread that adds it
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
