package org.myrobotlab.service.sear.run;

/** The libraries that a simulation can't do without. */
final class LibraryCheck {
    /** One class of each; jMonkeyEngine is not among them, without it there is no window and that is all. */
    private static final String[] CLASSES = {"com.bulletphysics.dynamics.DynamicsWorld", "javax.vecmath.Vector3f", "com.thoughtworks.xstream.XStream",
        "net.sf.geographiclib.Geodesic", "org.locationtech.proj4j.CRSFactory"};

    private LibraryCheck() {
    }

    /**
     * Looks for them all before anything starts; otherwise the one that is missing would be noticed in the midst of a simulation.
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
