// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

/** A service that belongs to another one, such as the Serial of a Roomba. */
public class Peer {
    /** Name in the registry. */
    public String name;
    /** Type without its package. */
    public String type;
    /** Whether it starts together with its owner. */
    public boolean autoStart = true;

    public Peer() {
    }

    public Peer(String name, String type) {
        this(name, type, true);
    }

    public Peer(String name, String type, boolean autoStart) {
        this.name = name;
        this.type = type;
        this.autoStart = autoStart;
    }

    @Override
    public String toString() {
        return name + " " + type;
    }
}
