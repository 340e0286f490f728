// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.After;
import org.junit.Before;

/**
 * Base of tests in the one MyRobotLab that all tests share. After each test it releases the started services and opens
 * a new project.
 */
abstract class InRealMrl {
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

    /** Opens a new project, releases the started services and waits until Python has removed their names. */
    static void release(RealMrl mrl) throws IOException, InterruptedException {
        assertEquals("", mrl.python("Runtime.start('sear', 'SEAR')", "for _name in Runtime.getServiceNames():",
            "    _service = Runtime.getService(_name)",
            "    if hasattr(_service, 'isSimulating') and _service.isSimulating(): _service.stopSimulation()",
            "_kept = Runtime.getService('sear').newProject()"));
        List<String> names = mrl.services();
        names.removeAll(mrl.firstServices());
        for (String name : names) {
            assertEquals("", mrl.python("if Runtime.getService('" + name + "') is not None: Runtime.release('"
                + name + "')"));
        }
        mrl.await("Python to forget them",
            () -> mrl.python("for _name in " + names.toString().replaceAll("([^\\[\\], ]+)", "'$1'") + ":",
            "    if globals().get(_name) is not None: print _name").isEmpty());
        assertEquals(mrl.firstServices(), mrl.services());
    }
}
