// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeSet;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/**
 * Section 5.1 of the dissertation: SEARproject zipped and renamed. The files of this folder are never changed.
 * {@code ...by-zip...} are from Info-ZIP, with and without the folder. The others copy byte by byte the form of Windows
 * Explorer (DOS characters, no folders), PowerShell (backslashes) and macOS Archive Utility (folders, data descriptors,
 * decomposed accents, {@code __MACOSX}).
 */
public class DissertationBundlesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void aSearProjectThatWasZippedAndRenamedOpensWhateverProgramZippedIt() throws Exception {
        File[] bundles = Paths.get(DissertationBundlesTest.class.getResource("dissertation").toURI()).toFile()
            .listFiles();
        assertEquals(Arrays.toString(bundles), 5, bundles.length);
        for (File bundle : bundles) {
            Project read = Bundle.load(bundle.toPath(), project.folder());
            assertEquals(bundle.getName(), "[M\u00fclltonne, my box]", names(read));
            assertEquals(bundle.getName(), 2, read.getRobots().get(0).getComponents().size());
            assertEquals(bundle.getName(), "[]", read.getWarnings().toString());
            assertEquals(bundle.getName(),
                new TreeSet<>(Arrays.asList("assets/cardboard.png", "drive.py", "environment/my box.xml",
                "environment/M\u00fclltonne.xml", "robot/body.xml", "robot/drive.xml", "robot/myRoomba.xml")), files());
            assertEquals(bundle.getName(), "[]", Bundle.check(bundle.toPath()).toString());
        }
    }

    @Test
    public void bundlesUnpackedAndZippedByHandOpen() throws Exception {
        RawZip zip = new RawZip();
        zip.stored("SEARproject/sear-version.txt", "1\n");
        zip.stored("SEARproject/environment/b.xml",
            "<Box><name>b</name><length>1</length><width>1</width><height>1</height></Box>");
        Path file = project.getRoot().toPath().resolve("again.sear");
        Files.write(file, zip.bytes());
        assertEquals("[b]", names(Bundle.load(file, project.folder())));
        assertEquals("[environment/b.xml]", files().toString());
        Path saved = project.getRoot().toPath().resolve("saved.sear");
        Bundle.save(project.folder(), saved);
        assertTrue(Files.size(saved) > 0);
    }

    private static String names(Project read) {
        return Arrays.toString(read.getEnvironment().stream().map(object -> object.getName()).toArray());
    }

    private TreeSet<String> files() throws Exception {
        Map<String, String> files = ProjectRule.files(project.folder());
        return new TreeSet<>(files.keySet());
    }
}
