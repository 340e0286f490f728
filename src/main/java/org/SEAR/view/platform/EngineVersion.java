package org.SEAR.view.platform;

import com.jme3.system.JmeSystem;

/** Which jMonkeyEngine is there, for a MyRobotLab that brings an older one than the window needs. */
public final class EngineVersion {
    private static final String NEEDED = "jMonkeyEngine 3.6 and LWJGL 3.3";

    private EngineVersion() {
    }

    /** What to tell and to do when classes of the engine are not those that the window was made for. */
    public static String misfit(LinkageError error) {
        return "the window needs " + NEEDED + ", and what is there is older or mixed: " + present()
            + "; \"sear install --replace-jme MRL_FOLDER\" puts the right ones into MyRobotLab; " + error;
    }

    private static String present() {
        try {
            return JmeSystem.getFullName() + ", LWJGL " + org.lwjgl.Version.getVersion();
        } catch (LinkageError e) {
            return "no version known";
        }
    }
}
