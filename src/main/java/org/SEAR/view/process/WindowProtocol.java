// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.process;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import org.SEAR.view.link.WorldLink;

/**
 * Protocol of a window process on its standard output: one byte for the message type, then its content. Big-endian, as
 * {@link DataOutputStream} writes; {@code 05 3F F0 00 00 00 00 00 00} is "set the speed to 1".
 */
public final class WindowProtocol {
    /** The window has drawn its first picture. */
    public static final int OPENED = 1;
    /** UTF: why there is no window. */
    public static final int PROBLEM = 2;
    /** UTF: a warning for the user. */
    public static final int WARNING = 3;
    /** boolean: pause or resume. */
    static final int PAUSE = 4;
    /** double: simulated seconds per real second. */
    static final int SPEED = 5;
    /** Pause and advance one step. */
    static final int STEP = 6;
    /** int robot, double speed, double radius. */
    static final int DRIVE = 7;
    /** Reset to the start. */
    static final int RESET = 8;
    /** boolean: include contact points in states. */
    static final int CONTACTS = 9;
    /** The user has closed the window. */
    public static final int CLOSED = 10;
    /** UTF: camera to take pictures, or empty. */
    static final int PICTURE = 11;

    private WindowProtocol() {
    }

    /**
     * Runs a command for the world.
     * @return false for an unknown command
     */
    public static boolean execute(int what, DataInputStream in, WorldLink world) throws IOException {
        switch (what) {
            case PAUSE:
                world.setPaused(in.readBoolean());
                return true;
            case SPEED:
                world.setSpeed(in.readDouble());
                return true;
            case STEP:
                world.singleStep();
                return true;
            case DRIVE:
                world.drive(in.readInt(), in.readDouble(), in.readDouble());
                return true;
            case RESET:
                world.reset();
                return true;
            case CONTACTS:
                world.wantContacts(in.readBoolean());
                return true;
            case PICTURE:
                String camera = in.readUTF();
                world.wantPicture(camera.isEmpty() ? null : camera);
                return true;
            default:
                return false;
        }
    }
}
