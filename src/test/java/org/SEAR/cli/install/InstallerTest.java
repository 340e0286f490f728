// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.Test;
import org.myrobotlab.service.link.PanelFiles;

/** Installs, updates and removes, and compares the trees. */
public class InstallerTest extends LaidOutMrl {
    @Test
    public void installAddsJarMissingLibrariesPanelsAndPickerEntries() throws Exception {
        Map<String, String> before = tree();
        install();
        Map<String, String> after = tree();
        List<String> added = after.keySet().stream().filter(path -> !before.containsKey(path))
            .collect(Collectors.toList());
        assertEquals(List.of("libraries/jar/jbullet-20101010-1.jar", "libraries/jar/sear.jar",
            "libraries/sear-install.json", "resource/SEAR.png", "resource/WebGui/app/service/js/SEARGui.js"), added);
        assertEquals(List.of("data/config/default/sear.yml", "libraries/serviceData.json"),
            before.keySet().stream().filter(path -> !before.get(path).equals(after.get(path)))
                .collect(Collectors.toList()));
        String data = after.get("libraries/serviceData.json");
        for (String service : new String[] {"SEAR", "LIDAR", "GPS"}) {
            assertTrue(data, data.contains("\"org.myrobotlab.service." + service + "\" : {"));
        }
        assertTrue("entries have Clock's fields",
            data.contains("\"class\" : \"org.myrobotlab.service.meta.ClockMeta\""));
        assertEquals(BARE_YML.replace("ServiceConfig", "SEARConfig"), after.get("data/config/default/sear.yml"));
    }

    @Test
    public void installingAgainChangesNothing() throws Exception {
        install();
        Map<String, String> once = tree();
        assertTrue(new Installer(mrl).install(plugin, false).isEmpty());
        install();
        assertEquals(once, tree());
    }

    @Test
    public void removeRestoresTheFolderToTheByte() throws Exception {
        Map<String, String> before = tree();
        install();
        remove();
        assertEquals(before, tree());
    }

    @Test
    public void anUpdateReplacesAndDeletesFilesAndCanBeRemovedCompletely() throws Exception {
        Map<String, String> before = tree();
        install();
        payload("1.1.0");
        Files.delete(plugin.resolve("jbullet-20101010-1.jar"));
        jar(plugin.resolve("jbullet-20260101.jar"), null, "com/bulletphysics/BulletGlobals.class",
            "com/bulletphysics/New.class");
        install();
        assertEquals("1.1.0", new Installer(mrl).old.version);
        assertTrue(Files.exists(mrl.resolve("libraries/jar/jbullet-20260101.jar")));
        assertFalse(Files.exists(mrl.resolve("libraries/jar/jbullet-20101010-1.jar")));
        remove();
        assertEquals(before, tree());
    }

    @Test
    public void filesThatTheUserChangedAreLeftAlone() throws Exception {
        install();
        text("resource/WebGui/app/service/js/SEARGui.js", "mine");
        payload("1.1.0");
        install();
        assertEquals("mine", Files.readString(mrl.resolve("resource/WebGui/app/service/js/SEARGui.js")));
        remove();
        assertEquals("mine", Files.readString(mrl.resolve("resource/WebGui/app/service/js/SEARGui.js")));
    }

    @Test
    public void serviceDataThatMrlRewroteSinceLosesOnlyOurEntries() throws Exception {
        install();
        String now = Files.readString(mrl.resolve("libraries/serviceData.json"));
        text("libraries/serviceData.json", now.replace("used to generate pulses", "ticks"));
        remove();
        String left = Files.readString(mrl.resolve("libraries/serviceData.json"));
        assertTrue(left, left.contains("ticks"));
        assertFalse(left, left.contains("service.SEAR") || left.contains("service.LIDAR")
            || left.contains("service.GPS"));
    }

    @Test
    public void resourceIsNotCreatedBeforeMrlsFirstStart() throws Exception {
        delete(mrl.resolve("resource"));
        Files.delete(mrl.resolve("libraries/serviceData.json"));
        Map<String, String> before = tree();
        InstallPlan plan = new Installer(mrl).install(plugin, false);
        assertTrue(plan.notes.toString(), plan.notes.stream().anyMatch(line -> line.startsWith("later   panels")));
        assertTrue(plan.notes.toString(), plan.notes.stream()
            .anyMatch(line -> line.startsWith("later   service picker")));
        plan.apply();
        assertFalse(Files.exists(mrl.resolve("resource")));
        remove();
        assertEquals(before, tree());
    }

    @Test
    public void panelsThatTheServicesCopiedAreRemovedToo() throws Exception {
        delete(mrl.resolve("resource"));
        install();
        text("resource/SEAR.png", "resource/SEAR.png");
        text("resource/SEAR/SEAR.py", "an older version's example");
        text("resource/.sear-files.properties", "SEAR/SEAR.py="
            + PanelFiles.hash("an older version's example".getBytes(StandardCharsets.UTF_8))
            + "\nSEAR.png=" + PanelFiles.hash("resource/SEAR.png".getBytes(StandardCharsets.UTF_8)));
        remove();
        assertFalse(Files.exists(mrl.resolve("resource/SEAR.png")));
        assertFalse(Files.exists(mrl.resolve("resource/SEAR/SEAR.py")));
        assertFalse(Files.exists(mrl.resolve("resource/.sear-files.properties")));
    }

    /** Deletes folders that become empty, but nothing that the user put there, not even a link to a folder. */
    @Test
    public void emptiedFoldersGoAndLinksStay() throws Exception {
        Path elsewhere = folder.newFolder("elsewhere").toPath();
        Files.createSymbolicLink(mrl.resolve("resource/SEAR"), elsewhere);
        text("resource/GPS/GPS.py", "gps");
        text("resource/SEAR/SEAR.py", "sear");
        install();
        text("resource/.sear-files.properties", "GPS/GPS.py=" + PanelFiles.hash("gps".getBytes(StandardCharsets.UTF_8))
            + "\nSEAR/SEAR.py=" + PanelFiles.hash("sear".getBytes(StandardCharsets.UTF_8)));
        remove();
        assertFalse(Files.exists(mrl.resolve("resource/GPS")));
        assertTrue(Files.isDirectory(mrl.resolve("resource/SEAR")));
        assertEquals(0, elsewhere.toFile().list().length);
    }

    @Test
    public void theParentFolderIsAcceptedIfItContainsOneMrl() throws Exception {
        assertEquals(mrl, new Installer(mrl.getParent()).mrl.root);
        Files.createDirectories(mrl.getParent().resolve("other"));
        Files.copy(mrl.resolve("myrobotlab.jar"), mrl.getParent().resolve("other/myrobotlab.jar"));
        assertRefused("contains several MyRobotLabs", mrl.getParent());
    }

    @Test
    public void foldersWithoutMrlAreRejected() throws Exception {
        assertRefused("is not a folder", mrl.resolve("nowhere"));
        assertRefused("contains no myrobotlab.jar", plugin);
        Files.writeString(mrl.resolve("myrobotlab.jar"), "not a zip");
        assertRefused("is not a readable jar", mrl);
    }

    @Test
    public void aNewerVersionIsRefused() throws Exception {
        payload("1.10.0");
        install();
        payload("1.9.0");
        assertRefused("SEAR 1.10.0 is installed", mrl);
    }

    @Test
    public void brokenServiceDataIsRefused() throws Exception {
        text("libraries/serviceData.json", "{\"serviceTypes\":");
        assertRefused("is not JSON", mrl);
        text("libraries/serviceData.json", "[]");
        assertRefused("has no serviceTypes", mrl);
    }

    @Test
    public void anIncompleteDistributionIsRefused() throws Exception {
        Files.delete(plugin.resolve("sear.jar"));
        assertRefused("The distribution is incomplete", mrl);
    }

    @Test
    public void aRunningMrlIsRefused() throws Exception {
        Process process = new ProcessBuilder("sh", "-c", "read line; exit 0", "org.myrobotlab.service.Runtime")
            .directory(mrl.toFile()).start();
        try {
            assertRefused("MyRobotLab is running from", mrl);
        } finally {
            process.getOutputStream().close();
            process.waitFor();
        }
        assertFalse(new Installer(mrl).install(plugin, false).isEmpty());
    }

    @Test
    public void removingWithoutAnInstallationIsRejected() throws Exception {
        try {
            new Installer(mrl).remove();
            throw new AssertionError("was not refused");
        } catch (InstallException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("SEAR is not installed in"));
        }
    }

    @Test
    public void aFailedWriteRestoresEverything() throws Exception {
        InstallPlan plan = new Installer(mrl).install(plugin, false);
        Files.createDirectories(mrl.resolve("resource/SEAR.png.sear-new/in the way"));
        Map<String, String> before = tree();
        try {
            plan.apply();
            throw new AssertionError("the write should have failed");
        } catch (IOException e) {
            assertEquals(before, tree());
        }
    }

    @Test
    public void aFolderThatCannotBeWrittenIsRefused() throws Exception {
        delete(mrl.resolve("libraries"));
        Files.writeString(mrl.resolve("libraries"), "a file in the way");
        assertRefused("libraries is a file but must be a folder", mrl);
    }

    /**
     * MyRobotLab sometimes rewrites its service data in its own format. An update must not take that for the original.
     */
    @Test
    public void anUpdateAfterMrlRewroteServiceDataCanBeRemovedCompletely() throws Exception {
        install();
        String now = Files.readString(mrl.resolve("libraries/serviceData.json"));
        text("libraries/serviceData.json",
            now.replace("\"license\" : \"apache\"", "\"license\" : \"apache\", \"link\" : null"));
        payload("1.1.0");
        install();
        remove();
        String left = Files.readString(mrl.resolve("libraries/serviceData.json"));
        assertTrue(left, left.contains("service.Clock"));
        assertFalse(left, left.contains("service.SEAR") || left.contains("service.LIDAR")
            || left.contains("service.GPS"));
    }

    @Test
    public void aDamagedPluginCanBeRemovedAndRepaired() throws Exception {
        Map<String, String> before = tree();
        install();
        Map<String, String> whole = tree();
        text("libraries/jar/sear.jar", "half a jar");
        install();
        assertEquals(whole, tree());
        text("libraries/jar/sear.jar", "half a jar");
        remove();
        assertEquals(before, tree());
    }

    @Test
    public void allFilesBelongToTheOwnerOfTheFolder() throws Exception {
        if ("root".equals(System.getProperty("user.name"))) {
            Files.setOwner(mrl, mrl.getFileSystem().getUserPrincipalLookupService().lookupPrincipalByName("nobody"));
        }
        install();
        for (String file : new String[] {"libraries/jar/sear.jar", "libraries/serviceData.json", "resource/SEAR.png"}) {
            assertEquals(file, Files.getOwner(mrl), Files.getOwner(mrl.resolve(file)));
        }
    }

    private void assertRefused(String message, Path where) throws IOException {
        Map<String, String> before = tree();
        try {
            new Installer(where).install(plugin, false);
            throw new AssertionError("was not refused: " + message);
        } catch (InstallException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(message));
        }
        assertEquals(before, tree());
    }
}
