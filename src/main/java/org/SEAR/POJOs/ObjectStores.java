// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ServiceLoader;
import java.util.function.Supplier;

/** The object store of the program, or the draft store of the calling thread. */
final class ObjectStores {
    private static final ObjectStore STORE = ServiceLoader.load(ObjectStore.class, ObjectStore.class.getClassLoader())
        .findFirst().orElseThrow(() -> new IllegalStateException(
            "no org.SEAR.POJOs.ObjectStore on the class path: sear.jar is incomplete"));

    /** Store that replaces the program's for the objects of a thread. */
    private static final ThreadLocal<ObjectStore> INSTEAD = new ThreadLocal<>();

    private ObjectStores() {
    }

    static ObjectStore get() {
        ObjectStore instead = INSTEAD.get();
        return instead == null ? STORE : instead;
    }

    /** Returns the name of a part of a ready robot, see {@link ObjectStore#partName}. */
    static String partName(SEARrobot robot, String part) {
        try {
            return get().partName(robot.getName(), part);
        } catch (IOException e) {
            throw new UncheckedIOException("the project can't be read: " + e.getMessage(), e);
        }
    }

    /** Returns whether the calling thread uses another store than the program's. */
    static boolean isRedirected() {
        return INSTEAD.get() != null;
    }

    /** Runs a maker with another store for the objects of the calling thread. */
    static <T> T with(ObjectStore store, Supplier<T> maker) {
        ObjectStore before = INSTEAD.get();
        INSTEAD.set(store);
        try {
            return maker.get();
        } finally {
            if (before == null) {
                INSTEAD.remove();
            } else {
                INSTEAD.set(before);
            }
        }
    }
}
