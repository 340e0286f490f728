package org.SEAR.real;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.After;
import org.junit.Before;

/** A test in the one MyRobotLab that all tests share: the services that it starts are released afterwards, and its project is put away. */
abstract class InRealMrl {
    /** The sources of SEAR. */
    static final Path ROOT = Path.of(System.getProperty("sear.root")).toAbsolutePath();
    RealMrl mrl;
    private List<String> before;

    @Before
    public final void findMyRobotLab() throws IOException, InterruptedException {
        mrl = RealMrl.shared();
        before = mrl.services();
    }

    @After
    public final void leaveItAsItWas() throws IOException, InterruptedException {
        StringBuilder script = new StringBuilder("_sear = Runtime.start('sear', 'SEAR')\n_sear.stopSimulation()\n_sear.setLockStep(False)\n"
            + "_sear.setSpeed(1)\n_sear.newProject()\n");
        for (String name : mrl.services()) {
            if (!before.contains(name)) {
                script.append("Runtime.release('").append(name).append("')\n");
            }
        }
        mrl.python(script + "Runtime.release('sear')");
    }
}
