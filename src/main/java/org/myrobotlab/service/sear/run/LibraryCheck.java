// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

/** Checks the libraries that a simulation needs. */
final class LibraryCheck {
    /** One class of each library. jMonkeyEngine is optional: without it there is no window. */
    private static final String[] CLASSES = {"com.bulletphysics.dynamics.DynamicsWorld", "javax.vecmath.Vector3f",
        "com.thoughtworks.xstream.XStream", "net.sf.geographiclib.Geodesic", "org.locationtech.proj4j.CRSFactory"};

    private LibraryCheck() {
    }

    /**
     * Checks all libraries before the start, so that none turns out missing during a simulation.
     *
     * @throws NoClassDefFoundError with the name of the class whose library is missing
     */
    static void check() {
        for (String name : CLASSES) {
            try {
                Class.forName(name, false, LibraryCheck.class.getClassLoader());
            } catch (ClassNotFoundException e) {
                throw (NoClassDefFoundError) new NoClassDefFoundError(name.replace('.', '/')).initCause(e);
            }
        }
    }
}
