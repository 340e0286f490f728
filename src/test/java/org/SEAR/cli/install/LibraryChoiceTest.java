// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import picocli.CommandLine;

/** Handling of libraries that MyRobotLab has in other versions, and the installer's messages about them. */
public class LibraryChoiceTest extends LaidOutMrl {
    private static final String OLD_CORE = "libraries/jar/jme3-core-3.3.2-stable.jar";
    private static final String OLD_NATIVES = "libraries/jar/lwjgl-3.2.3-natives-linux.jar";

    @Before
    public void addWindowLibraries() throws IOException {
        jar(plugin.resolve("lwjgl-3.3.2-natives-linux.jar"), null, "linux/x64/org/lwjgl/liblwjgl.so");
        jar(plugin.resolve("jme3-blender-3.3.2-stable.jar"), null,
            "com/jme3/scene/plugins/blender/BlenderLoader.class");
        System.setProperty("sear.home", plugin.getParent().toString());
    }

    @After
    public void forget() {
        System.clearProperty("sear.home");
    }

    /** Adds the libraries of a MyRobotLab from before 2024. */
    private void olderEngine() throws IOException {
        Files.delete(mrl.resolve("libraries/jar/jme3-core-3.6.1-stable.jar"));
        jar(mrl.resolve(OLD_CORE), "3.3.2", "com/jme3/math/Vector3f.class");
        jar(mrl.resolve(OLD_NATIVES), "3.2.3", "linux/x64/org/lwjgl/liblwjgl.so");
        jar(mrl.resolve("libraries/jar/jme3-bullet-3.3.2-stable.jar"), null, "com/jme3/bullet/BulletAppState.class");
        jar(mrl.resolve("libraries/jar/jme3-blender-3.3.2-stable.jar"), null,
            "com/jme3/scene/plugins/blender/BlenderLoader.class");
    }

    private String command(String... options) {
        StringWriter out = new StringWriter();
        String[] arguments = Arrays.copyOf(options, options.length + 1);
        arguments[options.length] = mrl.toString();
        int status = new CommandLine(new InstallCommand()).setOut(new PrintWriter(out, true))
            .setErr(new PrintWriter(out, true)).execute(arguments);
        assertEquals(out.toString(), 0, status);
        return out.toString();
    }

    private void assertSays(String text, String line) {
        assertTrue(line + " is not in\n" + text, List.of(text.split("\\R")).contains(line));
    }

    private static String lastLine(String text) {
        String[] lines = text.split("\\R");
        return lines[lines.length - 1];
    }

    @Test
    public void itNamesTheVersionThatItFoundAndKeeps() throws Exception {
        jar(mrl.resolve("libraries/jar/jbullet-20090101.jar"), null, "com/bulletphysics/BulletGlobals.class");
        String text = command();
        assertSays(text, "  keep    xstream-1.4.19.jar instead of 1.4.21: works");
        assertSays(text, "  keep    jme3-core-3.6.1-stable.jar: MyRobotLab has this library");
        assertSays(text, "  keep    gson-2.9.1.jar: myrobotlab.jar contains this library");
        assertSays(text, "  keep    jbullet-20090101.jar instead of 20101010-1: older, not tested with SEAR");
        assertEquals("Done. Start MyRobotLab; SEAR, LIDAR and GPS are among its services.", lastLine(text));
    }

    @Test
    public void newerLibrariesAreKeptToo() throws Exception {
        Files.delete(mrl.resolve("libraries/jar/jme3-core-3.6.1-stable.jar"));
        Files.delete(mrl.resolve("libraries/jar/xstream-1.4.19.jar"));
        jar(mrl.resolve("libraries/jar/jme3-core-3.7.0-stable.jar"), null, "com/jme3/math/Vector3f.class");
        jar(mrl.resolve("libraries/jar/xstream-1.4.3.jar"), null, "com/thoughtworks/xstream/XStream.class");
        jar(mrl.resolve("libraries/jar/jbullet-20301010.jar"), null, "com/bulletphysics/BulletGlobals.class");
        String text = command("--replace-jme");
        assertSays(text, "  keep    jme3-core-3.7.0-stable.jar instead of 3.6.1-stable: works");
        assertSays(text, "  keep    jbullet-20301010.jar instead of 20101010-1: newer, should work");
        assertSays(text, "  keep    xstream-1.4.3.jar instead of 1.4.21: older, not tested with SEAR");
    }

    @Test
    public void anOlderEngineIsKeptAndTheRemedyForTheWindowIsPrinted() throws Exception {
        olderEngine();
        String text = command();
        assertSays(text, "  keep    jme3-core-3.3.2-stable.jar instead of 3.6.1-stable: the window needs 3.6; "
            + "--replace-jme replaces it");
        assertSays(text, "  keep    lwjgl-3.2.3-natives-linux.jar instead of 3.3.2: the window needs 3.3; "
            + "--replace-jme replaces it");
        assertSays(text, "  keep    jme3-blender-3.3.2-stable.jar: MyRobotLab has this library");
        assertEquals("The window needs jMonkeyEngine 3.6, but MyRobotLab has jme3-core-3.3.2-stable.jar, so SEAR "
            + "runs without a window. To get one, run "
            + "\"sear install --replace-jme " + mrl + "\"; --remove restores the old one.", lastLine(text));
        assertFalse(Files.exists(mrl.resolve("libraries/jar/jme3-core-3.6.1-stable.jar")));
        assertTrue(lastLine(command()).startsWith("The window needs jMonkeyEngine 3.6"));
    }

    @Test
    public void theOlderEngineIsReplacedUpdatedAndRestored() throws Exception {
        olderEngine();
        Map<String, String> before = tree();
        String text = command("--replace-jme");
        assertEquals("Done. Start MyRobotLab; SEAR, LIDAR and GPS are among its services.", lastLine(text));
        assertFalse(Files.exists(mrl.resolve(OLD_CORE)) || Files.exists(mrl.resolve(OLD_NATIVES)));
        for (String jar : new String[] {"jme3-core-3.6.1-stable.jar", "lwjgl-3.3.2-natives-linux.jar",
            "jme3-bullet-3.3.2-stable.jar"}) {
            assertTrue(jar, Files.exists(mrl.resolve("libraries/jar").resolve(jar)));
        }
        Map<String, String> once = tree();
        assertTrue(command("--replace-jme").contains("Nothing to do: SEAR 1.0.0 is installed and complete."));
        assertEquals(once, tree());
        payload("1.1.0");
        command();
        remove();
        assertEquals(before, tree());
    }

    /** Such a folder has both versions, and the folder's order decides which one loads. */
    @Test
    public void besideANewerEngineTheOlderOneIsRemoved() throws Exception {
        jar(mrl.resolve(OLD_CORE), "3.3.2", "com/jme3/math/Vector3f.class");
        Map<String, String> before = tree();
        assertSays(command(), "  keep    jme3-core-3.6.1-stable.jar: MyRobotLab has this library");
        command("--replace-jme");
        assertFalse(Files.exists(mrl.resolve(OLD_CORE)));
        remove();
        assertEquals(before, tree());
    }

    @Test
    public void librariesReinstalledByMyRobotLabAreNotOverwritten() throws Exception {
        olderEngine();
        command("--replace-jme");
        jar(mrl.resolve(OLD_CORE), "3.3.2 again", "com/jme3/math/Vector3f.class");
        String again = Files.readString(mrl.resolve(OLD_CORE), StandardCharsets.ISO_8859_1);
        Files.delete(mrl.resolve("libraries/sear-replaced/lwjgl-3.2.3-natives-linux.jar"));
        String text = command("--remove");
        assertSays(text, "  lost    libraries/jar/lwjgl-3.2.3-natives-linux.jar: it is missing in "
            + "libraries/sear-replaced/; MyRobotLab can install it again");
        assertEquals(again, Files.readString(mrl.resolve(OLD_CORE), StandardCharsets.ISO_8859_1));
        assertFalse(Files.exists(mrl.resolve("libraries/sear-replaced")));
    }

    @Test
    public void withoutServiceDataTheLastLinesNameMissingParts() throws Exception {
        Files.delete(mrl.resolve("libraries/serviceData.json"));
        for (String done : new String[] {"Done. Start MyRobotLab; SEAR, LIDAR and GPS can be started.",
            "Nothing to do now: SEAR 1.0.0 is installed."}) {
            String text = command();
            assertSays(text, done);
            assertEquals("The service picker does not list SEAR, LIDAR and GPS yet. Start MyRobotLab once and install "
                + "again, or type the service type by hand.", lastLine(text));
        }
    }
}
