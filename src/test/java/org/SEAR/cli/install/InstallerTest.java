package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Lays out a folder as MyRobotLab's, installs, updates and removes, and compares the trees. */
public class InstallerTest {
    private static final String CLOCK = "{\"available\":true,\"description\":\"used to generate pulses\",\"isCloudService\":false,"
        + "\"simpleName\":\"Clock\",\"type\":\"org.myrobotlab.service.Clock\",\"dependencies\":[],\"workingLevel\":null,"
        + "\"class\":\"org.myrobotlab.service.meta.ClockMeta\"}";
    private static final String SERVICE_DATA = "{\"categoryTypes\":{\"sensors\":{\"name\":\"sensors\","
        + "\"serviceTypes\":[\"org.myrobotlab.service.Pir\"]}},"
        + "\"serviceTypes\":{\"org.myrobotlab.service.Clock\":" + CLOCK + "}}";
    private static final String BARE_YML = "!!org.myrobotlab.service.config.ServiceConfig\nlisteners: null\npeers: null\ntype: SEAR\n";

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private Path mrl;
    private Path plugin;

    @Before
    public void layOut() throws IOException {
        mrl = folder.newFolder("myrobotlab-1.1.1").toPath();
        jar(mrl.resolve("myrobotlab.jar"), null, "org/myrobotlab/service/Runtime.class", "org/slf4j/Logger.class", "com/google/gson/Gson.class");
        jar(mrl.resolve("libraries/jar/jme3-core-3.6.1-stable.jar"), null, "com/jme3/math/Vector3f.class");
        jar(mrl.resolve("libraries/jar/xstream-1.4.19.jar"), null, "com/thoughtworks/xstream/XStream.class");
        text("libraries/serviceData.json", SERVICE_DATA);
        text("data/config/default/runtime.yml", "!!org.myrobotlab.service.config.RuntimeConfig\ntype: Runtime\n");
        text("data/config/default/sear.yml", BARE_YML);
        text("resource/WebGui/app/service/js/ClockGui.js", "clock");
        plugin = folder.newFolder("plugin").toPath();
        payload("1.0.0");
    }

    private void payload(String version) throws IOException {
        jar(plugin.resolve("sear.jar"), version, "org/SEAR/POJOs/Box.class", "resource/WebGui/app/service/js/SEARGui.js", "resource/SEAR.png");
        jar(plugin.resolve("jme3-core-3.6.1-stable.jar"), null, "com/jme3/math/Vector3f.class");
        jar(plugin.resolve("xstream-1.4.21.jar"), null, "com/thoughtworks/xstream/XStream.class");
        jar(plugin.resolve("gson-2.9.1.jar"), null, "com/google/gson/Gson.class");
        jar(plugin.resolve("jbullet-20101010-1.jar"), null, "com/bulletphysics/BulletGlobals.class");
    }

    @Test
    public void installAddsJarMissingLibrariesPanelsAndPickerEntries() throws Exception {
        Map<String, String> before = tree();
        install();
        Map<String, String> after = tree();
        List<String> added = after.keySet().stream().filter(path -> !before.containsKey(path)).collect(Collectors.toList());
        assertEquals(List.of("libraries/jar/jbullet-20101010-1.jar", "libraries/jar/sear.jar", "libraries/sear-install.json", "resource/SEAR.png",
            "resource/WebGui/app/service/js/SEARGui.js"), added);
        assertEquals(List.of("data/config/default/sear.yml", "libraries/serviceData.json"),
            before.keySet().stream().filter(path -> !before.get(path).equals(after.get(path))).collect(Collectors.toList()));
        String data = after.get("libraries/serviceData.json");
        for (String service : new String[] {"SEAR", "LIDAR", "GPS"}) {
            assertTrue(data, data.contains("\"org.myrobotlab.service." + service + "\" : {"));
        }
        assertTrue("entries have Clock's fields", data.contains("\"class\" : \"org.myrobotlab.service.meta.ClockMeta\""));
        assertEquals(BARE_YML.replace("ServiceConfig", "SEARConfig"), after.get("data/config/default/sear.yml"));
    }

    @Test
    public void installingAgainChangesNothing() throws Exception {
        install();
        Map<String, String> once = tree();
        assertTrue(new Installer(mrl).install(plugin).isEmpty());
        install();
        assertEquals(once, tree());
    }

    @Test
    public void removeLeavesTheFolderAsItWasToTheByte() throws Exception {
        Map<String, String> before = tree();
        install();
        remove();
        assertEquals(before, tree());
    }

    @Test
    public void anUpdateReplacesAndDropsAndCanStillBeRemovedWhole() throws Exception {
        Map<String, String> before = tree();
        install();
        payload("1.1.0");
        Files.delete(plugin.resolve("jbullet-20101010-1.jar"));
        jar(plugin.resolve("jbullet-20260101.jar"), null, "com/bulletphysics/BulletGlobals.class", "com/bulletphysics/New.class");
        install();
        assertEquals("1.1.0", new Installer(mrl).installedVersion());
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
        assertFalse(left, left.contains("service.SEAR") || left.contains("service.LIDAR") || left.contains("service.GPS"));
    }

    @Test
    public void resourceIsNotCreatedBeforeMrlsFirstStart() throws Exception {
        delete(mrl.resolve("resource"));
        Files.delete(mrl.resolve("libraries/serviceData.json"));
        Map<String, String> before = tree();
        Plan plan = new Installer(mrl).install(plugin);
        assertTrue(plan.describe().toString(), plan.describe().stream().anyMatch(line -> line.startsWith("later   panels")));
        assertTrue(plan.describe().toString(), plan.describe().stream().anyMatch(line -> line.startsWith("later   service picker")));
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
        text("resource/.sear-files.properties", "SEAR/SEAR.py=" + Receipt.hash("an older version's example".getBytes(StandardCharsets.UTF_8)));
        remove();
        assertFalse(Files.exists(mrl.resolve("resource/SEAR.png")));
        assertFalse(Files.exists(mrl.resolve("resource/SEAR/SEAR.py")));
        assertFalse(Files.exists(mrl.resolve("resource/.sear-files.properties")));
    }

    @Test
    public void theFolderAboveWillDoWhenThereIsOneMrlInIt() throws Exception {
        assertEquals(mrl, new Installer(mrl.getParent()).root());
        Files.createDirectories(mrl.getParent().resolve("other"));
        Files.copy(mrl.resolve("myrobotlab.jar"), mrl.getParent().resolve("other/myrobotlab.jar"));
        assertRefused("holds several MyRobotLabs", mrl.getParent());
    }

    @Test
    public void whatIsNoMrlIsRefused() throws Exception {
        assertRefused("is not a folder", mrl.resolve("nowhere"));
        assertRefused("holds no myrobotlab.jar", plugin);
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
        Process process = new ProcessBuilder("sh", "-c", "read line; exit 0", "org.myrobotlab.service.Runtime").directory(mrl.toFile()).start();
        try {
            assertRefused("MyRobotLab is running from", mrl);
        } finally {
            process.getOutputStream().close();
            process.waitFor();
        }
        assertFalse(new Installer(mrl).install(plugin).isEmpty());
    }

    @Test
    public void removingWhatIsNotThereIsRefused() throws Exception {
        try {
            new Installer(mrl).remove(plugin);
            throw new AssertionError("was not refused");
        } catch (InstallException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("SEAR is not installed in"));
        }
    }

    @Test
    public void whenAWriteFailsEverythingIsAsItWas() throws Exception {
        Plan plan = new Installer(mrl).install(plugin);
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
        assertRefused("libraries is a file, and has to be a folder", mrl);
    }

    /** MyRobotLab writes its service data anew now and then, in its own shape: an update must not take that for what was there before. */
    @Test
    public void anUpdateAfterMrlRewroteServiceDataCanStillBeRemovedWhole() throws Exception {
        install();
        String now = Files.readString(mrl.resolve("libraries/serviceData.json"));
        text("libraries/serviceData.json", now.replace("\"license\" : \"apache\"", "\"license\" : \"apache\", \"link\" : null"));
        payload("1.1.0");
        install();
        remove();
        String left = Files.readString(mrl.resolve("libraries/serviceData.json"));
        assertTrue(left, left.contains("service.Clock"));
        assertFalse(left, left.contains("service.SEAR") || left.contains("service.LIDAR") || left.contains("service.GPS"));
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
    public void everythingBelongsToTheOwnerOfTheFolder() throws Exception {
        if ("root".equals(System.getProperty("user.name"))) {
            Files.setOwner(mrl, mrl.getFileSystem().getUserPrincipalLookupService().lookupPrincipalByName("nobody"));
        }
        install();
        for (String file : new String[] {"libraries/jar/sear.jar", "libraries/serviceData.json", "resource/SEAR.png"}) {
            assertEquals(file, Files.getOwner(mrl), Files.getOwner(mrl.resolve(file)));
        }
    }

    private void install() throws Exception {
        new Installer(mrl).install(plugin).apply();
    }

    private void remove() throws Exception {
        Installer installer = new Installer(mrl);
        installer.remove(plugin).apply();
        installer.removeEmptyFolders();
    }

    private void assertRefused(String message, Path where) throws IOException {
        Map<String, String> before = tree();
        try {
            new Installer(where).install(plugin);
            throw new AssertionError("was not refused: " + message);
        } catch (InstallException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(message));
        }
        assertEquals(before, tree());
    }

    private void text(String path, String content) throws IOException {
        Path file = mrl.resolve(path);
        Files.createDirectories(file.getParent());
        Files.writeString(file, content);
    }

    /** Each file's content by path; folders end in '/'. */
    private Map<String, String> tree() throws IOException {
        Map<String, String> files = new TreeMap<>();
        try (Stream<Path> paths = Files.walk(mrl)) {
            for (Path path : paths.collect(Collectors.toList())) {
                String name = mrl.relativize(path).toString().replace('\\', '/');
                files.put(Files.isDirectory(path) ? name + "/" : name,
                    Files.isDirectory(path) ? "" : new String(Files.readAllBytes(path), StandardCharsets.ISO_8859_1));
            }
        }
        return files;
    }

    private static void delete(Path tree) throws IOException {
        try (Stream<Path> paths = Files.walk(tree)) {
            List<Path> all = paths.collect(Collectors.toCollection(ArrayList::new));
            java.util.Collections.reverse(all);
            for (Path path : all) {
                Files.delete(path);
            }
        }
    }

    /** A jar whose entries contain their own names. */
    private static void jar(Path file, String version, String... entries) throws IOException {
        Files.createDirectories(file.getParent());
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        if (version != null) {
            manifest.getMainAttributes().put(Attributes.Name.IMPLEMENTATION_VERSION, version);
        }
        try (OutputStream out = Files.newOutputStream(file); JarOutputStream jar = new JarOutputStream(out, manifest)) {
            for (String entry : entries) {
                jar.putNextEntry(new ZipEntry(entry));
                jar.write(entry.getBytes(StandardCharsets.UTF_8));
                jar.closeEntry();
            }
        }
    }
}
