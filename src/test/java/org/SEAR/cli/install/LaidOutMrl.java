// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import org.junit.Before;
import org.junit.Rule;
import org.junit.rules.TemporaryFolder;

/** Base of tests with a folder laid out as MyRobotLab's and the plug-in folder of a distribution. */
abstract class LaidOutMrl {
    private static final String CLOCK = "{\"available\":true,\"description\":\"used to generate "
        + "pulses\",\"isCloudService\":false,"
        + "\"simpleName\":\"Clock\",\"type\":\"org.myrobotlab.service.Clock\",\"dependencies\":[],"
        + "\"workingLevel\":null,\"class\":\"org.myrobotlab.service.meta.ClockMeta\"}";
    private static final String SERVICE_DATA = "{\"categoryTypes\":{\"sensors\":{\"name\":\"sensors\","
        + "\"serviceTypes\":[\"org.myrobotlab.service.Pir\"]}},"
        + "\"serviceTypes\":{\"org.myrobotlab.service.Clock\":" + CLOCK + "}}";
    static final String BARE_YML = "!!org.myrobotlab.service.config.ServiceConfig\nlisteners: null\npeers: "
        + "null\ntype: SEAR\n";

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    Path mrl;
    Path plugin;

    @Before
    public void layOut() throws IOException {
        mrl = folder.newFolder("myrobotlab-1.1.1").toPath();
        jar(mrl.resolve("myrobotlab.jar"), null, "org/myrobotlab/service/Runtime.class", "org/slf4j/Logger.class",
            "com/google/gson/Gson.class");
        jar(mrl.resolve("libraries/jar/jme3-core-3.6.1-stable.jar"), null, "com/jme3/math/Vector3f.class");
        jar(mrl.resolve("libraries/jar/xstream-1.4.19.jar"), null, "com/thoughtworks/xstream/XStream.class");
        text("libraries/serviceData.json", SERVICE_DATA);
        text("data/config/default/runtime.yml", "!!org.myrobotlab.service.config.RuntimeConfig\ntype: Runtime\n");
        text("data/config/default/sear.yml", BARE_YML);
        text("resource/WebGui/app/service/js/ClockGui.js", "clock");
        plugin = folder.newFolder("plugin").toPath();
        payload("1.0.0");
    }

    final void payload(String version) throws IOException {
        jar(plugin.resolve("sear.jar"), version, "org/SEAR/POJOs/Box.class",
            "resource/WebGui/app/service/js/SEARGui.js", "resource/SEAR.png");
        jar(plugin.resolve("jme3-core-3.6.1-stable.jar"), null, "com/jme3/math/Vector3f.class");
        jar(plugin.resolve("xstream-1.4.21.jar"), null, "com/thoughtworks/xstream/XStream.class");
        jar(plugin.resolve("gson-2.9.1.jar"), null, "com/google/gson/Gson.class");
        jar(plugin.resolve("jbullet-20101010-1.jar"), null, "com/bulletphysics/BulletGlobals.class");
    }

    final void install() throws Exception {
        new Installer(mrl).install(plugin, false).apply();
    }

    final void remove() throws Exception {
        new Installer(mrl).remove().apply();
    }

    final void text(String path, String content) throws IOException {
        Path file = mrl.resolve(path);
        Files.createDirectories(file.getParent());
        Files.writeString(file, content);
    }

    /** Returns the content of each file by path; folder names end in '/'. */
    final Map<String, String> tree() throws IOException {
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

    static void delete(Path tree) throws IOException {
        try (Stream<Path> paths = Files.walk(tree)) {
            List<Path> all = paths.collect(Collectors.toCollection(ArrayList::new));
            java.util.Collections.reverse(all);
            for (Path path : all) {
                Files.delete(path);
            }
        }
    }

    /**
     * Makes a jar whose entries contain their own names. Its bytes are reproducible, so that an update changes the same
     * files each time.
     */
    static void jar(Path file, String version, String... entries) throws IOException {
        Files.createDirectories(file.getParent());
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        if (version != null) {
            manifest.getMainAttributes().put(Attributes.Name.IMPLEMENTATION_VERSION, version);
        }
        try (OutputStream out = Files.newOutputStream(file); JarOutputStream jar = new JarOutputStream(out)) {
            next(jar, JarFile.MANIFEST_NAME);
            manifest.write(jar);
            for (String entry : entries) {
                next(jar, entry);
                jar.write(entry.getBytes(StandardCharsets.UTF_8));
            }
        }
    }

    private static void next(JarOutputStream jar, String name) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTimeLocal(LocalDateTime.of(2026, 1, 1, 0, 0));
        jar.putNextEntry(entry);
    }
}
