package org.SEAR.POJOs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ServiceLoader;
import java.util.function.Supplier;

/** The one store of this program, as the project folder is one; where a thread makes drafts, theirs. */
final class ObjectStores {
    private static final ObjectStore STORE = ServiceLoader.load(ObjectStore.class, ObjectStore.class.getClassLoader()).findFirst()
        .orElseThrow(() -> new IllegalStateException("no org.SEAR.POJOs.ObjectStore on the class path: sear.jar is incomplete"));

    /** What keeps the objects that a thread makes just now, in the place of the one store. */
    private static final ThreadLocal<ObjectStore> INSTEAD = new ThreadLocal<>();

    private ObjectStores() {
    }

    static ObjectStore get() {
        ObjectStore instead = INSTEAD.get();
        return instead == null ? STORE : instead;
    }

    /** What a part of a ready robot is called, see {@link ObjectStore#partName}. */
    static String partName(SEARrobot robot, String part) {
        try {
            return get().partName(robot.getName(), part);
        } catch (IOException e) {
            throw new UncheckedIOException("the project can't be read: " + e.getMessage(), e);
        }
    }

    /** Whether another store keeps what this thread makes. */
    static boolean isRedirected() {
        return INSTEAD.get() != null;
    }

    /** Has another store keep what this thread makes meanwhile. */
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
