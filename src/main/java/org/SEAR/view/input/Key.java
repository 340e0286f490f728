// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.input;

import com.jme3.input.KeyInput;

/** Commands of the keys: table 5.5 of the dissertation and some more. */
public enum Key {
    SPIN_LEFT("H", "spin the robot left (again: faster)", KeyInput.KEY_H),
    SPIN_RIGHT("K", "spin the robot right (again: faster)", KeyInput.KEY_K),
    FORWARD("U", "drive forward (again: faster)", KeyInput.KEY_U),
    BACKWARD("J", "drive backward (again: faster)", KeyInput.KEY_J),
    STOP(";", "stop the robot", KeyInput.KEY_SEMICOLON, KeyInput.KEY_COLON),
    RESET("Enter", "reset the simulation and odometers", KeyInput.KEY_RETURN, KeyInput.KEY_NUMPADENTER),
    FLYCAM("Space", "flycam on or off", KeyInput.KEY_SPACE),
    FLY_UP("Q", "flycam up", KeyInput.KEY_Q),
    FLY_FORWARD("W", "flycam forward", KeyInput.KEY_W),
    FLY_LEFT("A", "flycam left", KeyInput.KEY_A),
    FLY_BACKWARD("S", "flycam backward", KeyInput.KEY_S),
    FLY_RIGHT("D", "flycam right", KeyInput.KEY_D),
    FLY_DOWN("Z", "flycam down", KeyInput.KEY_Z),
    FLY_FAST("Shift", "flycam four times as fast, while held", KeyInput.KEY_LSHIFT, KeyInput.KEY_RSHIFT),
    PAUSE("P", "pause or resume", KeyInput.KEY_P),
    STEP(".", "pause and advance one step of 1/60 s", KeyInput.KEY_PERIOD),
    FASTER("+", "simulate faster", KeyInput.KEY_ADD, KeyInput.KEY_EQUALS),
    SLOWER("-", "simulate slower", KeyInput.KEY_SUBTRACT, KeyInput.KEY_MINUS),
    NEXT_ROBOT("Tab", "follow and drive the next robot", KeyInput.KEY_TAB),
    HELP("F1", "this help", KeyInput.KEY_F1),
    BEAMS("F2", "beams of all sensors", KeyInput.KEY_F2),
    SHAPES("F3", "physics shapes, contacts, wheel rays", KeyInput.KEY_F3),
    FOLD("F4", "fold the panels to one line, or unfold", KeyInput.KEY_F4),
    LABELS("F5", "labels at the sensors", KeyInput.KEY_F5),
    CAMERA("F6", "next camera's picture, or none", KeyInput.KEY_F6),
    SCREENSHOT("F12", "save a picture of the window", KeyInput.KEY_F12),
    SENSOR("1 to 9", "beams of one sensor", KeyInput.KEY_1, KeyInput.KEY_2, KeyInput.KEY_3, KeyInput.KEY_4,
        KeyInput.KEY_5, KeyInput.KEY_6, KeyInput.KEY_7, KeyInput.KEY_8, KeyInput.KEY_9);

    /** Label of the key. */
    public final String label;
    /** Description of the command. */
    public final String help;
    private final int[] codes;

    Key(String label, String help, int... codes) {
        this.label = label;
        this.help = help;
        this.codes = codes;
    }

    /** Returns jMonkeyEngine's codes of the keys, by their position on a US keyboard. */
    int[] codes() {
        return codes.clone();
    }
}
