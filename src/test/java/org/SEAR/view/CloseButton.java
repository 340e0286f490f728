// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertTrue;

import com.sun.jna.Memory;
import com.sun.jna.NativeLibrary;
import com.sun.jna.NativeLong;
import com.sun.jna.Pointer;
import java.io.IOException;

/**
 * Presses a window's close button like a window manager: by a client message WM_PROTOCOLS, WM_DELETE_WINDOW (ICCCM
 * 4.2.8).
 */
final class CloseButton {
    private static final int CLIENT_MESSAGE = 33;
    private static final int EVENT_SIZE = 192;

    private CloseButton() {
    }

    static void press(String title) throws IOException, InterruptedException {
        Process search = new ProcessBuilder("xdotool", "search", "--name", title).start();
        String found = new String(search.getInputStream().readAllBytes()).trim();
        assertTrue("one window " + title + ": " + found, search.waitFor() == 0 && found.matches("\\d+"));
        NativeLibrary xlib = NativeLibrary.getInstance("libX11.so.6");
        Pointer display = xlib.getFunction("XOpenDisplay").invokePointer(new Object[] {null});
        Memory event = new Memory(EVENT_SIZE);
        event.clear();
        event.setInt(0, CLIENT_MESSAGE);
        event.setLong(32, Long.parseLong(found));
        event.setLong(40, atom(xlib, display, "WM_PROTOCOLS"));
        event.setInt(48, 32);
        event.setLong(56, atom(xlib, display, "WM_DELETE_WINDOW"));
        xlib.getFunction("XSendEvent")
            .invokeInt(new Object[] {display, new NativeLong(Long.parseLong(found)), 0, new NativeLong(0), event});
        xlib.getFunction("XCloseDisplay").invokeInt(new Object[] {display});
    }

    private static long atom(NativeLibrary xlib, Pointer display, String name) {
        return xlib.getFunction("XInternAtom").invokeLong(new Object[] {display, name, 0});
    }
}
