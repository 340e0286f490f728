package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.After;
import org.junit.Before;

/** A test in the one MyRobotLab that all tests share: the services that it starts are released afterwards, and its project is put away. */
abstract class InRealMrl {
    /** The sources of SEAR. */
    static final Path ROOT = Path.of(System.getProperty("sear.root")).toAbsolutePath();
    RealMrl mrl;

    @Before
    public final void findMyRobotLab() throws IOException, InterruptedException {
        mrl = RealMrl.shared();
    }

    @After
    public final void leaveItAsItWas() throws IOException, InterruptedException {
        release(mrl);
    }

    /** Releases what was started, puts the project away, and forgets what scripts had defined. */
    static void release(RealMrl mrl) throws IOException, InterruptedException {
        StringBuilder script = new StringBuilder();
        for (String name : mrl.services()) {
            if (!mrl.firstServices().contains(name)) {
                script.append("Runtime.release('").append(name).append("')\n");
            }
        }
        script.append("_sear = Runtime.start('sear', 'SEAR')\n_kept = _sear.newProject()\n");
        assertEquals("", mrl.python(script + "Runtime.release('sear')"));
        assertEquals(mrl.firstServices(), mrl.services());
    }
}
