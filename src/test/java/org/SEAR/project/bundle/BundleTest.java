// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.junit.Rule;
import org.junit.Test;

/** Saving, loading and starting a new project. */
public class BundleTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path place(String name) {
        return project.getRoot().toPath().resolve(name);
    }

    private void createProject() throws IOException {
        new Box("trash Can \u00e4\u6728", 1, 2, 3, 0);
        SEARrobot robot = new SEARrobot("r");
        robot.addWheel(new Wheel("w", 0.1, 0.02));
        project.put("assets/textures/mine.bin", "\u0000\u0001picture");
        project.put("userCode.py", "print 'never run on opening'\n");
        project.put("data/log.txt", "1 2 3\n");
    }

    @Test
    public void saveLoadSaveGivesTheSameBytesAndAllFiles() throws Exception {
        createProject();
        Bundle.save(project.folder(), place("a.sear"));
        Path elsewhere = place("other/place");
        Bundle.load(place("a.sear"), elsewhere);
        assertEquals(project.files(), ProjectRule.files(elsewhere));
        Bundle.save(elsewhere, place("b.sear"));
        assertArrayEquals(Files.readAllBytes(place("a.sear")), Files.readAllBytes(place("b.sear")));
    }

    @Test
    public void aNameThatAnObjectMayHaveIsOneThatABundleMayHave() throws Exception {
        new Box("x".repeat(100), 1, 1, 1, 0);
        Bundle.save(project.folder(), place("a.sear"));
        Bundle.load(place("a.sear"), place("other"));
        assertEquals(project.files(), ProjectRule.files(place("other")));
        new Box("caf\u00e9", 1, 1, 1, 0);
        try {
            new Box("cafe\u0301", 1, 1, 1, 0);
            fail("made");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("by more than capitals or accents' spelling"));
        }
        Bundle.save(project.folder(), place("b.sear"));
    }

    @Test
    public void aBundleWithBrokenModelsIsRefusedAsAWhole() throws Exception {
        new Box("mine", 1, 1, 1, 0);
        Path other = place("other");
        Files.createDirectories(other.resolve("environment"));
        Files.createDirectories(other.resolve("assets"));
        for (String name : new String[] {"a", "b"}) {
            String model = "<Model><name>" + name + "</name><path>" + name + ".obj</path></Model>";
            Files.writeString(other.resolve("environment/" + name + ".xml"), model);
            Files.writeString(other.resolve("assets/" + name + ".obj"), "v 0 0\n");
        }
        Bundle.save(other, place("a.sear"));
        Map<String, String> before = project.files();
        for (Path source : new Path[] {place("a.sear"), other}) {
            String said = assertThrows(ProjectException.class, () -> Bundle.load(source, project.folder()))
                .getMessage();
            for (String name : new String[] {"a", "b"}) {
                assertTrue(said, said.contains("environment/" + name + ".xml: path is \"" + name
                    + ".obj\", legal: a model that can be loaded (Model"
                    + " \"" + name + "\": " + name + ".obj can't be loaded"));
            }
            assertThrows(ProjectException.class,
                () -> Bundle.importEnvironment(source, project.folder(), Progress.NONE));
        }
        assertEquals(before, project.files());
    }

    @Test
    public void aBundleUnpackedByHandIsSavedAsTheSameBundle() throws Exception {
        createProject();
        Bundle.save(project.folder(), place("a.sear"));
        project.put("sear-version.txt", "1\n");
        Bundle.save(project.folder(), place("b.sear"));
        assertArrayEquals(Files.readAllBytes(place("a.sear")), Files.readAllBytes(place("b.sear")));
        project.put("sear-version.txt", "my own notes\n");
        try {
            Bundle.save(project.folder(), place("c.sear"));
            fail("saved");
        } catch (ProjectException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("it has the name of the bundle's own version entry"));
        }
    }

    @Test
    public void loadingKeepsTheOldProjectAsBackup() throws Exception {
        createProject();
        Bundle.save(project.folder(), place("a.sear"));
        Map<String, String> saved = project.files();
        new Box("later", 1, 1, 1, 0);
        Map<String, String> later = project.files();
        assertEquals(1, Bundle.load(place("a.sear"), project.folder()).getRobots().size());
        assertEquals(saved, project.files());
        assertEquals(later, ProjectRule.files(place("SEARproject.backup-1")));
    }

    @Test
    public void aNewProjectKeepsTenBackups() throws Exception {
        assertNull(Bundle.newProject(project.folder(), Progress.NONE));
        for (int i = 1; i <= 12; i++) {
            new Box("box" + i, 1, 1, 1, 0);
            assertEquals(place("SEARproject.backup-" + i), Bundle.newProject(project.folder(), Progress.NONE));
            assertFalse(Files.exists(project.folder()));
        }
        assertFalse(Files.exists(place("SEARproject.backup-2")));
        assertTrue(Files.exists(place("SEARproject.backup-3/environment/box3.xml")));
    }

    @Test
    public void openedExamplesDisplaceNoBackupOfTheUser() throws Exception {
        new Box("mine", 1, 1, 1, 0);
        Map<String, String> mine = project.files();
        Path bundle = place("example.sear");
        Bundle.save(project.folder(), bundle);
        Files.move(project.folder(), place("elsewhere"));
        new Box("work", 1, 1, 1, 0);
        Map<String, String> work = project.files();
        for (int i = 0; i < 12; i++) {
            Bundle.load(bundle, project.folder(), true, Progress.NONE);
            assertEquals(mine, project.files());
            assertNull(Bundle.newProject(project.folder(), Progress.NONE));
        }
        assertEquals(work, ProjectRule.files(place("SEARproject.backup-1")));
        assertFalse(Files.exists(place("SEARproject.backup-2")));
    }

    @Test
    public void aChangedExampleIsBackedUp() throws Exception {
        new Box("mine", 1, 1, 1, 0);
        Path bundle = place("example.sear");
        Bundle.save(project.folder(), bundle);
        Bundle.load(bundle, project.folder(), true, Progress.NONE);
        new Box("more", 1, 1, 1, 0);
        Map<String, String> changed = project.files();
        assertEquals(place("SEARproject.backup-2"), Bundle.newProject(project.folder(), Progress.NONE));
        assertEquals(changed, ProjectRule.files(place("SEARproject.backup-2")));
        Bundle.load(bundle, project.folder(), false, Progress.NONE);
        assertEquals("a bundle of one's own", place("SEARproject.backup-3"),
            Bundle.newProject(project.folder(), Progress.NONE));
    }

    /**
     * Makes a backup of a project with a sparse map of this size.
     * @return the messages
     */
    private List<String> retireWithMap(long bytes) throws Exception {
        new Box("box", 1, 1, 1, 0);
        Path map = Files.createDirectories(project.folder().resolve("assets")).resolve("map.tif");
        try (RandomAccessFile file = new RandomAccessFile(map.toFile(), "rw")) {
            file.setLength(bytes);
        }
        List<String> said = new ArrayList<>();
        Bundle.newProject(project.folder(), new PercentProgress("replacing", project.folder(), said::add));
        return said;
    }

    @Test
    public void backupsAreAGigabyteAtMostAndTheNewestStays() throws Exception {
        assertEquals(List.of(), retireWithMap(400 << 20));
        assertEquals(List.of(), retireWithMap(401 << 20));
        assertEquals(List.of("the backup " + place("SEARproject.backup-1") + " was removed: SEAR keeps the last 10 "
            + "backups of a project, at most 1024 MB together"), retireWithMap(402 << 20));
        assertFalse(Files.exists(place("SEARproject.backup-1")));
        assertTrue(Files.exists(place("SEARproject.backup-2/assets/map.tif")));
        assertEquals(2, retireWithMap(2L << 30).size());
        assertFalse(Files.exists(place("SEARproject.backup-3")));
        assertEquals(2L << 30, Files.size(place("SEARproject.backup-4/assets/map.tif")));
    }

    @Test
    public void hiddenFilesStayOutAndArchivesAndLinksAreRefusedWhenSaving() throws Exception {
        createProject();
        project.put(".git/config", "x");
        project.put("environment/.Box.xml.tmp", "x");
        Bundle.save(project.folder(), place("a.sear"));
        Bundle.load(place("a.sear"), place("copy"));
        assertFalse(Files.exists(place("copy/.git")));
        byte[] before = Files.readAllBytes(place("a.sear"));
        project.put("assets/more.zip", "PK\u0003\u0004...");
        Files.createSymbolicLink(project.folder().resolve("assets/link"), place("a.sear"));
        try {
            Bundle.save(project.folder(), place("a.sear"));
            fail("was saved");
        } catch (ProjectException e) {
            assertEquals(e.getMessage(), 2, e.getProblems().size());
        }
        assertArrayEquals(before, Files.readAllBytes(place("a.sear")));
    }

    @Test
    public void highlyCompressedProjectsLoadWithProgress() throws Exception {
        createProject();
        Files.write(project.folder().resolve("assets/zeros.dat"), new byte[20 << 20]);
        List<Long> told = new ArrayList<>();
        Bundle.save(project.folder(), place("a.sear"), (file, done, total) -> told.add(done));
        int saving = told.size();
        Bundle.load(place("a.sear"), place("copy"), (file, done, total) -> told.add(done));
        assertTrue(told.toString(), saving >= 9 && told.size() - saving >= 9);
        assertEquals(20 << 20, Files.size(place("copy/assets/zeros.dat")));
    }

    @Test
    public void anUnfinishedSwapIsFinishedWhenTheProjectIsOpened() throws Exception {
        createProject();
        Bundle.save(project.folder(), place("a.sear"));
        Files.move(project.folder(), place("SEARproject.next"));
        assertEquals(1, Project.read(project.folder()).getRobots().size());
        Bundle.load(place("a.sear"), place("SEARproject.next"));
        new Box("still here", 1, 1, 1, 0);
        Bundle.load(place("a.sear"), project.folder());
        assertFalse(Files.exists(place("SEARproject.next")));
        assertTrue(Files.exists(place("SEARproject.backup-1/environment/still here.xml")));
    }
}
