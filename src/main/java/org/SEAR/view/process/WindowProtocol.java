package org.SEAR.view.process;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import org.SEAR.view.link.WorldLink;

/**
 * What a window in a process of its own says on its standard output: a byte for what, then what belongs to it. Big-endian, as
 * {@link DataOutputStream} writes; {@code 05 3F F0 00 00 00 00 00 00} is "set the speed to 1".
 */
public final class WindowProtocol {
    /** The window shows its first picture. */
    public static final int OPENED = 1;
    /** There can't be a window; UTF: why. */
    public static final int PROBLEM = 2;
    /** UTF: a warning for the user. */
    public static final int WARNING = 3;
    /** boolean: pause or go on. */
    static final int PAUSE = 4;
    /** double: simulated seconds per real second. */
    static final int SPEED = 5;
    /** Pause, and one step. */
    static final int STEP = 6;
    /** int robot, double speed, double radius. */
    static final int DRIVE = 7;
    /** Back to the start. */
    static final int RESET = 8;
    /** boolean: whether contact points are wanted. */
    static final int CONTACTS = 9;
    /** The user has closed the window. */
    public static final int CLOSED = 10;
    /** UTF: the camera whose pictures are wanted; empty for none. */
    static final int PICTURE = 11;

    private WindowProtocol() {
    }

    /**
     * Obeys a command for the world.
     *
     * @return false for a byte that is none
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
