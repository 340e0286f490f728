// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.input;

import com.jme3.input.RawInputListener;
import com.jme3.input.event.JoyAxisEvent;
import com.jme3.input.event.JoyButtonEvent;
import com.jme3.input.event.KeyInputEvent;
import com.jme3.input.event.MouseButtonEvent;
import com.jme3.input.event.MouseMotionEvent;
import com.jme3.input.event.TouchEvent;
import java.util.EnumSet;
import java.util.Set;
import org.SEAR.view.scene.CameraRig;

/** Turns keys and mouse into commands. Window thread only. */
public final class Controls implements RawInputListener {
    /** jMonkeyEngine's value for one notch of a mouse wheel. */
    private static final float NOTCH = 120;
    private final KeyLayout layout;
    private final CameraRig camera;
    private final Commands commands;
    private final Set<Key> held = EnumSet.noneOf(Key.class);
    private int buttons;

    /** Runs the keys' commands except those of the camera. */
    public interface Commands {
        /** @param number of the sensor, from 0, for {@link Key#SENSOR} */
        void pressed(Key key, int number);
    }

    public Controls(KeyLayout layout, CameraRig camera, Commands commands) {
        this.layout = layout;
        this.camera = camera;
        this.commands = commands;
    }

    @Override
    public void onKeyEvent(KeyInputEvent event) {
        Key key = layout.key(event.getKeyCode());
        if (key == null || event.isRepeating()) {
            return;
        }
        if (event.isPressed() ? held.add(key) : held.remove(key)) {
            steer(key, event.isPressed() ? 1 : -1);
        }
        if (event.isPressed()) {
            commands.pressed(key, KeyLayout.digit(event.getKeyCode()));
        }
    }

    /** Releases all held keys, for a window that has lost the focus. */
    public void release() {
        for (Key key : held) {
            steer(key, -1);
        }
        held.clear();
        buttons = 0;
    }

    private void steer(Key key, int sign) {
        switch (key) {
            case FLY_UP:
                camera.steer(0, sign, 0);
                break;
            case FLY_DOWN:
                camera.steer(0, -sign, 0);
                break;
            case FLY_LEFT:
                camera.steer(-sign, 0, 0);
                break;
            case FLY_RIGHT:
                camera.steer(sign, 0, 0);
                break;
            case FLY_FORWARD:
                camera.steer(0, 0, sign);
                break;
            case FLY_BACKWARD:
                camera.steer(0, 0, -sign);
                break;
            case FLY_FAST:
                camera.setFast(sign > 0);
                break;
            default:
                break;
        }
    }

    @Override
    public void onMouseMotionEvent(MouseMotionEvent event) {
        if (buttons > 0) {
            camera.drag(event.getDX(), event.getDY());
        }
        if (event.getDeltaWheel() != 0) {
            camera.zoom(event.getDeltaWheel() / NOTCH);
        }
    }

    @Override
    public void onMouseButtonEvent(MouseButtonEvent event) {
        buttons = Math.max(0, buttons + (event.isPressed() ? 1 : -1));
    }

    @Override
    public void beginInput() {
        // nothing to prepare: each event runs its command
    }

    @Override
    public void endInput() {
        // nothing to finish
    }

    @Override
    public void onJoyAxisEvent(JoyAxisEvent event) {
        // joysticks are not used
    }

    @Override
    public void onJoyButtonEvent(JoyButtonEvent event) {
        // joysticks are not used
    }

    @Override
    public void onTouchEvent(TouchEvent event) {
        // touch screens are not used
    }
}
