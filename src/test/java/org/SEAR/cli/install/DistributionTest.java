// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.ConnectException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.SEAR.FreePort;
import org.SEAR.documents.DocBlock;
import org.junit.BeforeClass;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.SEAR.Needs;

/** The release zip: its content, its launcher in any folder, and its installer. */
@Needs("distZip")
public class DistributionTest {
    @ClassRule
    public static final TemporaryFolder SHARED = new TemporaryFolder();
    private static final String NOBODY = "65534";
    private static final long PATIENCE_SECONDS = 240;
    private static final long LOOK_MILLIS = 100;

    private static Distribution distribution;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    @BeforeClass
    public static void unpack() throws IOException {
        distribution = new Distribution(SHARED.newFolder("a folder with spaces").toPath());
    }

    private static Set<String> entries(Path jar) throws IOException {
        try (ZipFile zip = new ZipFile(jar.toFile())) {
            return zip.stream().map(ZipEntry::getName).filter(name -> !name.endsWith("/"))
                .collect(Collectors.toCollection(TreeSet::new));
        }
    }

    private Distribution.Result sear(String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(distribution.launcher().toString()));
        command.addAll(Arrays.asList(arguments));
        return Distribution.run(folder.getRoot().toPath(), folder.newFolder().toPath(), command);
    }

    private Path myRobotLab() throws IOException {
        Path mrl = folder.newFolder("my robot lab").toPath();
        Files.createDirectories(mrl.resolve("libraries/jar"));
        Files.createFile(mrl.resolve("libraries/jar/own.jar"));
        Files.copy(distribution.home().resolve("lib/sear-embedded-mrl.jar"), mrl.resolve("myrobotlab.jar"));
        Files.writeString(mrl.resolve("libraries/serviceData.json"), "{\"serviceTypes\":{}}");
        return mrl;
    }

    @Test
    public void thePluginHasItsOwnClassesOnly() throws IOException {
        Set<String> plugin = entries(distribution.home().resolve("plugin/sear.jar"));
        Set<String> host = entries(distribution.home().resolve("lib/sear-embedded-mrl.jar"));
        List<String> foreign = plugin.stream().filter(name -> name.endsWith(".class"))
            .filter(name -> host.contains(name) || !name.matches("(org/SEAR|org/myrobotlab|sear_hints)/.*"))
            .collect(Collectors.toList());
        assertEquals(List.of(), foreign);
        assertFalse(plugin.stream().anyMatch(name -> name.startsWith("org/myrobotlab/embedded")
            || name.startsWith("org/SEAR/cli")));
    }

    @Test
    public void thePluginHasTemplatesPanelsIconsAndExamples() throws IOException {
        Set<String> plugin = entries(distribution.home().resolve("plugin/sear.jar"));
        assertTrue(plugin.containsAll(
            List.of("templates/controller.py", "templates/userCode.py", "org/SEAR/assets/textures/roomba.jpg")));
        for (String service : new String[] {"SEAR", "LIDAR", "GPS"}) {
            for (String file : new String[] {"WebGui/app/service/js/%sGui.js", "WebGui/app/service/views/%sGui.html",
                "%s.png", "%s/%s.py"}) {
                String name = "resource/" + file.replace("%s", service);
                assertTrue(name, plugin.contains(name));
            }
        }
        for (String drive : List.of("arduino_rover", "balance", "car_waypoints", "follow_ball",
            "gps_waypoints", "lidar_mapper",
            "line_follower", "map_driver", "maze_solver",
                "mountain_climber", "obstacle_avoidance", "radar_turret", "wall_follower")) {
            assertTrue(drive, plugin.contains("resource/SEAR/drive/" + drive + ".py"));
        }
    }

    /** In a folder without examples the ones inside the jar are offered. */
    @Test
    public void theExamplesThatDriveAreOfferedEverywhere() throws Exception {
        Path script = folder.newFile("offered.py").toPath();
        Files.writeString(script, "sear = Runtime.start('sear', 'SEAR')\nprint ', '.join(sear.getExampleScripts())\n"
            + "print sear.getExampleScript('wall_follower.py').split('\\n')[0]\n");
        Distribution.Result result = sear(script.toString(), "--headless", "--port", "none");
        assertEquals(result.toString(), 0, result.status);
        assertTrue(result.toString(), result.out.contains(
            "arduino_rover.py, balance.py, car_waypoints.py, follow_ball.py, gps_waypoints.py, lidar_mapper.py,"
            + " line_follower.py, map_driver.py, maze_solver.py, mountain_climber.py, obstacle_avoidance.py,"
            + " radar_turret.py, wall_follower.py"));
        assertTrue(result.toString(), result.out.contains("# Follows the wall on its right"));
    }

    /** Native libraries of the window for the three systems, and for both processor types where the system has two. */
    @Test
    public void thePluginHasTheWindowsNativesForLinuxMacAndWindows() throws IOException {
        Set<String> natives = new TreeSet<>();
        for (Path jar : distribution.jars("plugin")) {
            natives.addAll(entries(jar));
        }
        for (String platform : new String[] {"linux/x64/%slib%s.so", "linux/arm64/%slib%s.so",
            "macos/x64/%slib%s.dylib", "macos/arm64/%slib%s.dylib", "windows/x64/%s%s.dll"}) {
            assertTrue(platform, natives.contains(String.format(platform, "org/lwjgl/", "lwjgl")));
            assertTrue(platform, natives.contains(String.format(platform, "org/lwjgl/glfw/", "glfw")));
            assertTrue(platform, natives.contains(String.format(platform, "org/lwjgl/opengl/", "lwjgl_opengl")));
        }
    }

    @Test
    public void librariesOfMyRobotLabAreNotInstalled() throws IOException {
        for (Path jar : distribution.jars("plugin")) {
            String name = jar.getFileName().toString();
            assertFalse(name, name.matches("(slf4j|logback|jackson|jython|jssc|snakeyaml|sear-embedded|undertow).*"));
        }
    }

    @Test
    public void everythingIsReadableForTheUser() throws IOException {
        for (String file : new String[] {"LICENSE", "LICENSES.md", "README.md", "docs/install.md", "examples/maze.py",
            "scripts/demo.py", "bin/sear.bat"}) {
            assertTrue(file, Files.isRegularFile(distribution.home().resolve(file)));
        }
    }

    /** A container has no locale; Java then assumes ASCII file names. */
    @Test
    public void umlautsAreWrittenWithoutALocaleToo() throws Exception {
        Path script = folder.newFile("umlaut.py").toPath();
        Files.writeString(script, "from org.SEAR.POJOs import Box\nBox('T\u00fcr', 1, 1, "
            + "1)\nBox(u'\u65e5', 1, 1, 1)\n");
        Distribution.Result result = Distribution.run(folder.getRoot().toPath(), folder.newFolder().toPath(),
            List.of("env", "LC_ALL=C", "LANG=C",
            distribution.launcher().toString(), script.toString(), "--headless", "--port", "none"));
        assertEquals(result.toString(), 0, result.status);
        assertTrue(Files.exists(folder.getRoot().toPath().resolve("SEARproject/environment/T\u00fcr.xml")));
        Path here = Files.copy(script, folder.newFolder("T\u00fcr").toPath().resolve("umlaut.py"));
        Distribution.Result unknown = Distribution.run(here.getParent(), folder.newFolder().toPath(),
            List.of("env", "LC_ALL=xx_XX.UTF-8",
            distribution.launcher().toString(), "umlaut.py", "--headless", "--port", "none"));
        assertEquals(unknown.toString(), 0, unknown.status);
        Distribution.Result bare = Distribution.run(folder.getRoot().toPath(), folder.newFolder().toPath(),
            List.of("env", "LC_ALL=C", "LANG=C",
            Distribution.java().toString(), "-cp", distribution.home().resolve("plugin") + "/*:" + distribution.home()
            .resolve("lib") + "/*", "org.SEAR.cli.SearCommand", script.toString(), "--headless", "--port", "none"));
        assertEquals(bare.toString(), 1, bare.status);
        assertTrue(bare.toString(), bare.err.contains("with LC_ALL=C.UTF-8 in the environment"));
    }

    @Test
    public void theLauncherRunsFromAnotherFolderAndThroughALink() throws Exception {
        Distribution.Result version = sear("--version");
        assertEquals(version.toString(), 0, version.status);
        Path link = Files.createSymbolicLink(folder.getRoot().toPath().resolve("sear link"), distribution.launcher());
        Distribution.Result linked = Distribution.run(folder.getRoot().toPath(), folder.newFolder().toPath(),
            List.of(link.toString(), "--version"));
        assertEquals(linked.toString(), 0, linked.status);
        assertEquals(version.out, linked.out);
        assertEquals(2, sear("nowhere.py").status);
    }

    @Test
    public void theExampleOfThePanelRuns() throws Exception {
        Path script = Path.of(System.getProperty("sear.root", "."), "resources/resource/SEAR/SEAR.py").toAbsolutePath();
        Distribution.Result result = sear(script.toString(), "--headless", "--speed", "max", "--port", "none");
        assertEquals(result.toString(), 0, result.status);
        String[] metres = result.out.split(" m to the wall\\R");
        assertEquals(result.toString(), 5, metres.length);
        double wall = 2.95 - 0.15; // distance from the sensor's start to the wall's near face
        assertEquals(result.toString(), wall - 5 * 0.3, Double.parseDouble(metres[4]), 0.1);
    }

    /** Runs as in MyRobotLab's Python tab while a simulation with these sensors runs. */
    @Test
    public void theExamplesOfLidarAndGpsPrintTheirMeasurements() throws Exception {
        Path resources = Path.of(System.getProperty("sear.root", "."), "resources/resource").toAbsolutePath();
        Path script = folder.getRoot().toPath().resolve("both.py");
        Files.writeString(script, "sear = Runtime.start('sear', 'SEAR')\nsear.loadProject('" + distribution.home()
            .resolve("examples/sensors.sear")
            + "')\nsear.startSimulation()\nsear.simSleep(1)\npython.execFile('" + resources.resolve("LIDAR/LIDAR.py")
            + "')\nsear.simSleep(3)\nprint 'truth ' + str(min(sear.getLidarResult('myLidar')))\npython.execFile('"
            + resources.resolve("GPS/GPS.py")
            + "')\nsear.simSleep(3.5)\nprint 'truth ' + ' '.join([str(x) for x in sear.getGpsResult('gpsUnit1')])\n");
        Distribution.Result result = sear(script.toString(), "--headless", "--speed", "max", "--port", "none");
        assertEquals(result.toString(), 0, result.status);
        assertEquals("no warnings", "", result.err);
        Matcher scan = Pattern.compile("181 readings, the nearest at (\\d+) mm\\Rtruth (\\S+)\\R").matcher(result.out);
        assertTrue(result.toString(), scan.lookingAt());
        assertEquals(Double.parseDouble(scan.group(2)), Integer.parseInt(scan.group(1)) / 1000.0, 0.002);
        Matcher fix = Pattern.compile("(latitude (\\S+), longitude (\\S+), altitude (\\S+) m\\R){3,4}truth (\\S+) "
            + "(\\S+) (\\S+)\\R").matcher(result.out.substring(scan.end()));
        assertTrue(result.toString(), fix.matches());
        assertEquals(Double.parseDouble(fix.group(5)), Double.parseDouble(fix.group(2)), 2e-6);
        assertEquals(Double.parseDouble(fix.group(6)), Double.parseDouble(fix.group(3)), 2e-6);
        assertEquals(Double.parseDouble(fix.group(7)), Double.parseDouble(fix.group(4)), 0.1);
    }

    @Test
    public void itInstallsUpdatesAndRemovesByCommand() throws Exception {
        Path mrl = myRobotLab();
        List<String> before = tree(mrl);
        Distribution.Result dry = sear("install", "--dry-run", mrl.toString());
        assertEquals(dry.toString(), 0, dry.status);
        assertTrue(dry.out, dry.out.contains("libraries/jar/sear.jar") && dry.out.contains("Nothing was changed"));
        assertEquals(before, tree(mrl));
        Distribution.Result installed = sear("install", mrl.toString());
        assertEquals(installed.toString(), 0, installed.status);
        assertTrue(installed.out, installed.out.contains("Done. Start MyRobotLab"));
        assertTrue(Files.exists(mrl.resolve("libraries/jar/jbullet-20101010-1.jar")));
        Distribution.Result again = sear("install", mrl.toString());
        assertTrue(again.toString(), again.status == 0 && again.out.contains("Nothing to do"));
        Distribution.Result removed = sear("install", "--remove", mrl.toString());
        assertTrue(removed.toString(), removed.status == 0 && removed.out.contains("SEAR was removed."));
        assertEquals(before, tree(mrl));
        Distribution.Result nothing = sear("install", "--remove", mrl.toString());
        assertEquals(nothing.toString(), 1, nothing.status);
        assertTrue(nothing.err, nothing.err.startsWith("sear install: SEAR is not installed in "));
    }

    @Test
    public void theCommandsOfThePageInstallAndRemove() throws Exception {
        Path mrl = myRobotLab();
        List<String> before = tree(mrl);
        List<String> said = new ArrayList<>();
        for (String command : DocBlock.commands("docs/install.md", "bin/sear install")) {
            Distribution.Result result = Distribution.run(distribution.home(), folder.newFolder().toPath(),
                List.of("sh", "-c", command.replace("/path/to/myrobotlab", "\"$0\""), mrl.toString()));
            assertEquals(command + result, 0, result.status);
            said.add(result.out);
        }
        assertEquals(3, said.size());
        assertTrue(said.get(0), said.get(0).contains("Done. Start MyRobotLab"));
        assertTrue(said.get(1), said.get(1).contains("Nothing to do"));
        assertTrue(said.get(2), said.get(2).contains("SEAR was removed."));
        assertEquals(before, tree(mrl));
    }

    /** Runs in the unpacked folder on a free port. */
    @Test
    public void theCommandOfThePageStartsTheEmbeddedMyRobotLab() throws Exception {
        Path here = folder.newFolder("here").toPath();
        for (String jars : new String[] {"plugin", "lib"}) {
            Files.createSymbolicLink(here.resolve(jars), distribution.home().resolve(jars));
        }
        int port;
        port = FreePort.find();
        Files.writeString(Files.createDirectories(here.resolve("data/config/default")).resolve("webgui.yml"),
            "!!org.myrobotlab.service.config.WebGuiConfig\nport: " + port + "\ntype: WebGui\n");
        List<String> commands = DocBlock.commands("docs/embedded-and-real.md", "java -cp");
        assertEquals(1, commands.size());
        File log = here.resolve("log.txt").toFile();
        ProcessBuilder shell = new ProcessBuilder("sh", "-c", "exec " + commands.get(0)).directory(here.toFile())
            .redirectErrorStream(true).redirectOutput(log);
        shell.environment().merge("PATH", Distribution.java().getParent().toString(), (path, first) -> first
            + File.pathSeparator + path);
        Process process = shell.start();
        try {
            URL services = new URL("http://localhost:" + port + "/api/service");
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
            while (!answer(services).contains("sear@")) {
                assertTrue(Files.readString(log.toPath()), process.isAlive() && System.nanoTime() < end);
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(LOOK_MILLIS));
            }
            assertTrue(answer(services).contains("python@"));
        } finally {
            process.destroyForcibly().waitFor();
        }
    }

    /** Returns an empty text until the server answers. */
    private static String answer(URL address) throws IOException {
        try (InputStream in = address.openStream()) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (ConnectException e) {
            return "";
        }
    }

    @Test
    public void foldersWithoutMyRobotLabAreRejectedByCommand() throws Exception {
        Distribution.Result result = sear("install", folder.newFolder("empty").toString());
        assertEquals(result.toString(), 1, result.status);
        assertTrue(result.err, result.err.startsWith("sear install: ")
            && result.err.contains("contains no myrobotlab.jar"));
        assertEquals(2, sear("install").status);
    }

    /** Runs as another user if the tests run as root, who may write everywhere. */
    @Test
    public void aFolderOfAnotherUserIsRefused() throws Exception {
        Path mrl = myRobotLab();
        List<String> command = new ArrayList<>();
        if ("root".equals(System.getProperty("user.name"))) {
            command.addAll(List.of("setpriv", "--reuid=" + NOBODY, "--clear-groups"));
            open(SHARED.getRoot().toPath());
            open(folder.getRoot().toPath());
        }
        command.addAll(List.of(distribution.launcher().toString(), "install", mrl.toString()));
        Files.createDirectories(mrl.resolve("resource/WebGui"));
        for (String closed : new String[] {"libraries/jar", "libraries/serviceData.json", "resource"}) {
            if (command.contains("setpriv")) {
                openAll(mrl);
            }
            Files.setPosixFilePermissions(mrl.resolve(closed), PosixFilePermissions.fromString("r-xr-xr-x"));
            List<String> before = tree(mrl);
            Distribution.Result result = Distribution.run(folder.getRoot().toPath(), folder.newFolder()
                .toPath(), command);
            Files.setPosixFilePermissions(mrl.resolve(closed), PosixFilePermissions.fromString("rwxr-xr-x"));
            assertEquals(result.toString(), 1, result.status);
            assertTrue(result.err, result.err.startsWith("sear install: No permission to write into "
                + mrl.resolve(closed)));
            assertEquals(before, tree(mrl));
        }
    }

    /** Makes everything writable, so that the one closed path causes the error. */
    private static void openAll(Path root) throws IOException {
        try (Stream<Path> paths = Files.walk(root)) {
            for (Path path : (Iterable<Path>) paths::iterator) {
                Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rwxrwxrwx"));
            }
        }
    }

    /** A shell whose command line names myrobotlab.jar and calls the installer is not a running MyRobotLab. */
    @Test
    public void theCallerIsNotTakenForMyRobotLab() throws Exception {
        Path mrl = myRobotLab();
        Distribution.Result result = Distribution.run(mrl, folder.newFolder().toPath(), List.of("sh", "-c",
            "test -f myrobotlab.jar && '" + distribution.launcher() + "' install --dry-run . && true"));
        assertEquals(result.toString(), 0, result.status);
        assertTrue(result.out, result.out.contains("Nothing was changed"));
    }

    private static void open(Path path) throws IOException {
        Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private static List<String> tree(Path root) throws IOException {
        try (Stream<Path> paths = Files.walk(root)) {
            return paths.sorted().map(path -> root.relativize(path)
                + (Files.isDirectory(path) ? "/" : " " + path.toFile().length())).collect(Collectors.toList());
        }
    }
}
