package org.SEAR.view.platform;

import com.sun.jna.Function;
import com.sun.jna.Platform;
import java.util.logging.Level;
import java.util.logging.Logger;

/** Memory outside of Java's heap. Any thread. */
public final class NativeMemory {
    private static final Logger LOG = Logger.getLogger(NativeMemory.class.getName());

    private NativeMemory() {
    }

    /**
     * Lets glibc return what the graphics driver has freed: each window's thread has a heap of its own there, and without this a process that has
     * opened 50 windows keeps some 200 MB of empty heaps. Elsewhere there is no such need.
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
