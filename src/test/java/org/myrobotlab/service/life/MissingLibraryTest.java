// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.life;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** An error status names a missing library and the remedy; the service continues. */
@Category(Slow.class)
public class MissingLibraryTest {
    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    @Before
    public void project() {
        TestWorld.build(temporary.getRoot().toPath());
    }

    /** Runs the probe on the program's class path without the jars whose names have this beginning. */
    private static List<?> runWithout(String jar) throws Exception {
        List<URL> path = new ArrayList<>();
        boolean there = false;
        for (String entry : System.getProperty("sear.cliClasspath").split(File.pathSeparator)) {
            if (new File(entry).getName().startsWith(jar)) {
                there = true;
            } else {
                path.add(new File(entry).toURI().toURL());
            }
        }
        assertTrue(jar + " is not on the class path anyway", there);
        path.add(LibraryProbe.class.getProtectionDomain().getCodeSource().getLocation());
        try (URLClassLoader loader = new URLClassLoader(path.toArray(new URL[0]),
            ClassLoader.getPlatformClassLoader())) {
            ClassLoader before = Thread.currentThread().getContextClassLoader();
            Thread.currentThread().setContextClassLoader(loader);
            try {
                Object probe = loader.loadClass(LibraryProbe.class.getName()).getConstructor().newInstance();
                return (List<?>) ((Callable<?>) probe).call();
            } finally {
                Thread.currentThread().setContextClassLoader(before);
            }
        }
    }

    private static void assertNamed(String jar, String type) throws Exception {
        List<?> heard = runWithout(jar);
        String all = heard.toString();
        assertTrue(all, heard.get(0).toString().startsWith("thrown: ") && all.contains("error: "));
        for (String part : new String[] {type, "a library is missing or broken",
            "run \"sear install\" for this MyRobotLab again", "libraries/jar"}) {
            assertTrue(part + " in " + all, heard.stream().skip(1)
                .anyMatch(status -> status.toString().contains(part)));
        }
        TestWorld.assertNoThreads();
    }

    @Test
    public void withAllLibrariesTheProbeRuns() throws Exception {
        assertEquals(List.of("runs"), runWithout("bootstrap"));
    }

    @Test
    public void withoutThePhysics() throws Exception {
        assertNamed("jbullet", "com/bulletphysics");
    }

    @Test
    public void withoutVecmath() throws Exception {
        assertNamed("vecmath", "javax/vecmath");
    }

    @Test
    public void withoutXstream() throws Exception {
        assertNamed("xstream", "com/thoughtworks/xstream");
    }

    @Test
    public void withoutJMonkeyEngineTheSimulationStillRuns() throws Exception {
        assertEquals(List.of("runs"), runWithout("jme3-core"));
    }

    @Test
    public void withoutGeographicLib() throws Exception {
        assertNamed("GeographicLib", "net/sf/geographiclib");
    }

    @Test
    public void withoutProj4j() throws Exception {
        assertNamed("proj4j-1", "org/locationtech/proj4j");
    }
}
