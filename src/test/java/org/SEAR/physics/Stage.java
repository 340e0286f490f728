// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.io.IOException;
import java.nio.file.Path;
import org.SEAR.POJOs.Floor;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.BodyRun;
import org.junit.rules.TemporaryFolder;

/** A project for one scene: objects made while it is open belong to it. */
final class Stage implements AutoCloseable {
    private static final String KEY = "sear.project";

    private final TemporaryFolder folder = new TemporaryFolder();
    private final String before = System.getProperty(KEY);
    private BodyRun run;

    Stage() throws IOException {
        folder.create();
        System.setProperty(KEY, folder().toString());
    }

    /**
     * Adds a square floor with its top at height 0.
     * @param side of the floor, metres
     */
    Stage(double side) throws IOException {
        this();
        new Floor("floor", side, side);
    }

    Path folder() {
        return folder.getRoot().toPath().resolve("SEARproject");
    }

    /** Starts a world with the objects of this project. */
    BodyRun start() throws ProjectException {
        run = new BodyRun(folder());
        return run;
    }

    @Override
    public void close() {
        if (run != null) {
            run.close();
        }
        if (before == null) {
            System.clearProperty(KEY);
        } else {
            System.setProperty(KEY, before);
        }
        folder.delete();
    }
}
