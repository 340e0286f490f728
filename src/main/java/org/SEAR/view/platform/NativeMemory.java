// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.platform;

import com.sun.jna.Function;
import com.sun.jna.Platform;
import java.util.logging.Level;
import java.util.logging.Logger;

/** Memory outside the Java heap. Any thread. */
public final class NativeMemory {
    private static final Logger LOG = Logger.getLogger(NativeMemory.class.getName());

    private NativeMemory() {
    }

    /**
     * Makes glibc return memory that the graphics driver has freed. Each window's thread has its own glibc heap; 50
     * closed windows would keep some 200 MB. Does nothing on other systems.
     */
    public static void giveBack() {
        if (Platform.isLinux()) {
            try {
                Function.getFunction("c", "malloc_trim").invokeInt(new Object[] {0L});
            } catch (UnsatisfiedLinkError e) {
                LOG.log(Level.FINE, "a C library without malloc_trim", e);
            }
        }
    }
}
