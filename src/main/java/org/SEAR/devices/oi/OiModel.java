// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

/**
 * Differences between the robots with this protocol, as data. Sources: SCI specification 2005, Create OI 2006, Create 2
 * OI 2016.
 */
public enum OiModel {
    /** Roomba 400 and older: the Serial Command Interface. */
    ROOMBA400("roomba400", true, 16, 3, 255, true),
    /** iRobot Create. */
    CREATE("create", false, 16, 42, 255, true),
    /** iRobot Create 2 and Roomba 600. */
    CREATE2("create2", false, 5, 107, 0, false);

    private final String name;
    private final boolean ladder;
    private final int songs;
    private final int lastPacket;
    private final int noInfrared;
    private final boolean caster;

    OiModel(String name, boolean ladder, int songs, int lastPacket, int noInfrared, boolean caster) {
        this.name = name;
        this.ladder = ladder;
        this.songs = songs;
        this.lastPacket = lastPacket;
        this.noInfrared = noInfrared;
        this.caster = caster;
    }

    /**
     * Finds a model by name.
     *
     * @throws IllegalArgumentException that lists the valid models
     */
    public static OiModel of(String name) {
        for (OiModel model : values()) {
            if (model.name.equals(name)) {
                return model;
            }
        }
        throw new IllegalArgumentException("model is \"" + name + "\", legal: roomba400, create, create2");
    }

    /** Name in the object grammar. */
    public String getName() {
        return name;
    }

    /** Whether modes change one step at a time: 128, 130, 132. */
    public boolean isLadder() {
        return ladder;
    }

    /** Number of songs that it stores. */
    public int getSongs() {
        return songs;
    }

    /** Highest packet id. */
    public int getLastPacket() {
        return lastPacket;
    }

    /** Value of packet 17 without a received byte. */
    public int getNoInfrared() {
        return noInfrared;
    }

    /** Whether packet 7 reports a drop of the front wheel. */
    public boolean hasCasterSwitch() {
        return caster;
    }

    /** Whether packet 20 is the right wheel's lead in millimetres instead of degrees. */
    public boolean isAngleInMillimetres() {
        return this == ROOMBA400;
    }
}
