// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.platform;

import com.jme3.system.JmeSystem;

/** Version of jMonkeyEngine, for a MyRobotLab that contains an older one than the window needs. */
public final class EngineVersion {
    private static final String NEEDED = "jMonkeyEngine 3.6 and LWJGL 3.3";

    private EngineVersion() {
    }

    /** Returns the error message for incompatible engine classes, including the remedy. */
    public static String misfit(LinkageError error) {
        return "the window needs " + NEEDED + " but found older or mixed versions: " + present()
            + "; \"sear install --replace-jme MRL_FOLDER\" installs the right ones; " + error;
    }

    private static String present() {
        try {
            return JmeSystem.getFullName() + ", LWJGL " + org.lwjgl.Version.getVersion();
        } catch (LinkageError e) {
            return "unknown version";
        }
    }
}
