// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.project.edit.ProjectEditor;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;

/** One process at a time works on a project folder. */
public class ProjectOwnerTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<Process> processes = new ArrayList<>();

    /** Another program: creates an object, prints the outcome, and stays until the end of its input. */
    public static void main(String[] name) throws IOException {
        try {
            new Box(name[0], 1, 1, 1, 0);
            System.out.println("made");
        } catch (RuntimeException e) {
            System.out.println(e.getMessage());
        }
        System.in.read();
    }

    private Process start(String object) throws IOException {
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        Process process = new ProcessBuilder(java, "-XX:TieredStopAtLevel=1", "-cp",
            System.getProperty("java.class.path"),
            "-Dsear.project=" + project.folder(), ProjectOwnerTest.class.getName(), object)
            .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        processes.add(process);
        return process;
    }

    private static String line(Process process) throws IOException {
        return new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8)).readLine();
    }

    @After
    public void end() throws Exception {
        for (Process process : processes) {
            process.destroyForcibly().waitFor();
        }
    }

    private String inUseBy(long pid) {
        return "the project " + project.folder() + " is in use by process " + pid + " (";
    }

    @Test
    public void anotherProcessIsRefusedByNameAndChangesNothing() throws Exception {
        new Box("mine", 1, 1, 1, 0);
        Map<String, String> before = project.files();
        String refused = line(start("other"));
        assertTrue(refused, refused.contains(inUseBy(ProcessHandle.current().pid())));
        assertTrue(refused, refused.contains("-Dsear.project=FOLDER"));
        assertEquals(before, project.files());
    }

    @Test
    public void everyChangeIsRefusedWhileAnotherProcessOwnsTheProject() throws Exception {
        Process owner = start("theirs");
        assertEquals("made", line(owner));
        Map<String, String> before = project.files();
        String inUse = inUseBy(owner.pid());
        Path folder = project.folder();
        Path bundle = project.getRoot().toPath().resolve("copy.sear");
        Bundle.save(folder, bundle);
        RuntimeException refused = assertThrows(RuntimeException.class, () -> new Box("mine", 1, 1, 1, 0));
        assertTrue(refused.toString(), refused.getMessage().contains(inUse));
        List<IOException> refusals = List.of(
            assertThrows(IOException.class, () -> Bundle.newProject(folder, Progress.NONE)),
            assertThrows(IOException.class, () -> Bundle.load(bundle, folder)),
            assertThrows(IOException.class, () -> Bundle.importEnvironment(bundle, folder, Progress.NONE)),
            assertThrows(IOException.class, () -> new ProjectEditor(folder).undo()),
            assertThrows(IOException.class, () -> ProjectSwap.claim(folder)));
        refusals.forEach(refusal -> assertTrue(refusal.toString(), refusal.getMessage().contains(inUse)));
        assertEquals(before, project.files());
    }

    @Test
    public void aProcessThatWasKilledOwnsNothing() throws Exception {
        Process owner = start("theirs");
        assertEquals("made", line(owner));
        owner.destroyForcibly().waitFor();
        Path file = project.folder().resolveSibling(".SEARproject.owner");
        assertEquals(owner.pid() + "\n", Files.readString(file));
        new Box("mine", 1, 1, 1, 0);
        assertEquals(ProcessHandle.current().pid() + "\n", Files.readString(file));
    }

    @Test
    public void aProcessThatWorksElsewhereReleasesTheProject() throws Exception {
        new Box("mine", 1, 1, 1, 0);
        ProjectRule.unread(() -> new Box("elsewhere", 1, 1, 1, 0));
        assertEquals("made", line(start("theirs")));
    }

    @Test
    public void otherFoldersThanThePresentProjectHaveNoOwner() throws Exception {
        new Box("mine", 1, 1, 1, 0);
        Path bundle = project.getRoot().toPath().resolve("copy.sear");
        Bundle.save(project.folder(), bundle);
        Path other = project.getRoot().toPath().resolve("other");
        Bundle.load(bundle, other);
        assertTrue(Files.notExists(other.resolveSibling(".other.owner")));
        assertEquals("the first one stays owned", -1, line(start("theirs")).indexOf("made"));
    }
}
