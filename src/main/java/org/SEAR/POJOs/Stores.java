package org.SEAR.POJOs;

import java.util.ServiceLoader;

/** The one store of this program. */
final class Stores {
    private static final ObjectStore STORE = ServiceLoader.load(ObjectStore.class, ObjectStore.class.getClassLoader()).findFirst()
        .orElseThrow(() -> new IllegalStateException("no org.SEAR.POJOs.ObjectStore on the class path: sear.jar is incomplete"));

    private Stores() {
    }

    static ObjectStore get() {
        return STORE;
    }
}
