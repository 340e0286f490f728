// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.FileReasons;
import org.junit.Assume;
import org.junit.Rule;
import org.junit.Test;

/** Files that block a save, objects written at a bad moment, and the messages. */
public class FilesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private void assertNotSaved(Path target) throws Exception {
        try {
            Bundle.save(project.folder(), target);
            fail("saved to " + target);
        } catch (IOException e) {
            assertEquals(target + " is a link, a pipe or a device; choose the name of an ordinary file",
                e.getMessage());
        }
    }

    @Test
    public void nothingIsSavedOntoALinkAPipeOrADevice() throws Exception {
        Assume.assumeTrue(Files.exists(Paths.get("/dev/null")));
        new Box("b", 1, 1, 1, 0);
        Path root = project.getRoot().toPath();
        Path other = Files.write(root.resolve("precious.txt"), new byte[3]);
        assertNotSaved(Files.createSymbolicLink(root.resolve("link.sear"), other));
        assertEquals(3, Files.size(other));
        assertNotSaved(Files.createSymbolicLink(root.resolve("nowhere.sear"), root.resolve("gone")));
        Path pipe = root.resolve("pipe.sear");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        assertNotSaved(pipe);
        assertNotSaved(Paths.get("/dev/null"));
        assertFalse(Files.isRegularFile(Paths.get("/dev/null"), LinkOption.NOFOLLOW_LINKS));
    }

    @Test
    public void anObjectThatIsWrittenWhileTheProjectIsReplacedWaitsAndIsInTheNewOne() throws Exception {
        new Box("old", 1, 1, 1, 0);
        Path bundle = project.getRoot().toPath().resolve("a.sear");
        Bundle.save(project.folder(), bundle);
        List<Throwable> failures = new ArrayList<>();
        Thread writer = new Thread(() -> new Box("late", 1, 1, 1, 0));
        writer.setUncaughtExceptionHandler((thread, e) -> failures.add(e));
        Bundle.load(bundle, project.folder(), (file, done, total) -> {
            if (writer.getState() == Thread.State.NEW) {
                writer.start();
                while (writer.getState() != Thread.State.WAITING && writer.getState() != Thread.State.TERMINATED) {
                    Thread.onSpinWait();
                }
                assertFalse(Files.exists(project.folder().resolve("environment/late.xml")));
            }
        });
        writer.join();
        assertEquals("[]", failures.toString());
        assertEquals(2, Project.read(project.folder()).getEnvironment().size());
    }

    @Test
    public void aWheelWithoutARobotIsAWarning() throws Exception {
        project.put("robot/w.xml", "<Wheel><name>w</name><radius>1</radius><width>1</width></Wheel>");
        assertEquals("[robot/w.xml: Wheel \"w\" is on no robot and is left out; robot.addWheel(wheel) adds it, or a "
            + "<wheel> in the robot's file]", Project.read(project.folder()).getWarnings().toString());
    }

    @Test
    public void remainsOfADeletedBackupAreRemoved() throws Exception {
        new Box("b", 1, 1, 1, 0);
        Path rest = project.folder().resolveSibling("SEARproject.deleting");
        Files.createDirectories(rest.resolve("assets"));
        for (int i = 1; i <= 12; i++) {
            new Box("b", 1, 1, 1, i);
            assertTrue(Bundle.newProject(project.folder(), Progress.NONE).endsWith("SEARproject.backup-" + i));
        }
        assertFalse(Files.exists(rest));
        assertFalse(Files.exists(project.folder().resolveSibling("SEARproject.backup-2")));
        assertTrue(Files.exists(project.folder().resolveSibling("SEARproject.backup-3")));
    }

    @Test
    public void messagesSayWhy() {
        assertTrue(FileReasons.of(new AccessDeniedException("/x/a.sear")).startsWith("/x/a.sear: permission denied"));
        assertTrue(FileReasons.of(new IOException("No space left on device")).contains("the disk is full"));
        assertEquals("a reason of its own", FileReasons.of(new IOException("a reason of its own")));
    }

    /** Repeated runs of an example must not displace the user's own projects from the ten backups. */
    @Test
    public void theSameProjectIsKeptOnce() throws Exception {
        new Box("mine", 1, 1, 1, 0);
        Bundle.newProject(project.folder(), Progress.NONE);
        for (int i = 0; i < 15; i++) {
            new Box("example", 1, 1, 1, 0);
            new Box("second", 1, 1, 1, 0);
            Bundle.newProject(project.folder(), Progress.NONE);
        }
        new Box("example", 1, 1, 1, 0);
        new Box("second", 1, 1, 1, 1);
        Bundle.newProject(project.folder(), Progress.NONE);
        List<String> kept = new ArrayList<>();
        for (int i = 1; i < 20; i++) {
            Path backup = project.folder().resolveSibling("SEARproject.backup-" + i);
            if (Files.exists(backup)) {
                kept.add(i + (Files.exists(backup.resolve("environment/mine.xml")) ? " mine" : ""));
            }
        }
        assertEquals("[1 mine, 16, 17]", kept.toString());
    }
}
