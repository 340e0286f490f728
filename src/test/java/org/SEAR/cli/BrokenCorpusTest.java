// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.SEAR.project.BrokenFiles;
import org.SEAR.project.models.BrokenModels;
import org.SEAR.project.xml.Xml;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/**
 * For every broken model, picture or folder {@code sear check} ends with status 2 and the right message, within 5 s of
 * CPU time and 200 MB above the idle program. The idle program needs more than 20 MB; the JVM has at most 220 MB of
 * heap and direct memory.
 */
public class BrokenCorpusTest {
    private static final int LEAST = 120;
    private static final long MOST_MILLIS = 5000;
    private static final String[] MEMORY = {"-XX:+UseSerialGC", "-Xmx170m", "-XX:MaxDirectMemorySize=50m"};
    private static final String BOX = "<Box><name>o</name><length>1</length><width>1</width><height>1</height>";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private int count;

    /** Makes a project folder with its expected messages. */
    private Path folder(String name, String... expected) throws IOException {
        Path folder = temporary.getRoot().toPath().resolve("corpus")
            .resolve(String.format("%03d %s", count++, name.replace('/', '-')));
        Files.createDirectories(folder.resolve("SEARproject/environment"));
        Files.createDirectories(folder.resolve("SEARproject/assets"));
        Files.write(folder.resolve("expected"), List.of(expected));
        return folder.resolve("SEARproject");
    }

    private static void put(Path project, String file, String text) throws IOException {
        Files.createDirectories(project.resolve(file).getParent());
        Files.write(project.resolve(file), text.getBytes(StandardCharsets.UTF_8));
    }

    private void models() throws IOException {
        BrokenModels broken = BrokenModels.models();
        for (Map.Entry<String, byte[]> file : broken.files.entrySet()) {
            for (int mass = 0; mass < 2; mass++) {
                Path project = folder(file.getKey(), "environment/o.xml", "path is \"" + file.getKey() + "\"",
                    broken.messages.get(file.getKey()));
                Files.write(project.resolve("assets").resolve(file.getKey()), file.getValue());
                put(project, "environment/o.xml", "<Model><name>o</name><path>" + file.getKey() + "</path><mass>" + mass
                    + "</mass></Model>");
            }
        }
    }

    private void pictures() throws IOException {
        BrokenModels broken = BrokenModels.pictures();
        for (Map.Entry<String, byte[]> file : broken.files.entrySet()) {
            Path project = folder(file.getKey(), "environment/o.xml", "image is \"" + file.getKey() + "\"",
                broken.messages.get(file.getKey()));
            Files.write(project.resolve("assets").resolve(file.getKey()), file.getValue());
            put(project, "environment/o.xml", BOX + "<image>" + file.getKey() + "</image></Box>");
        }
    }

    private void files() throws IOException {
        for (BrokenFiles broken : BrokenFiles.all()) {
            if (broken.messages.isEmpty()) {
                continue;
            }
            String[] expected = new String[broken.messages.size()];
            for (int i = 0; i < expected.length; i++) {
                expected[i] = broken.beginning(i);
            }
            Path project = folder(broken.file, expected);
            for (Map.Entry<String, String> good : BrokenFiles.GOOD.entrySet()) {
                put(project, good.getKey(), good.getValue());
            }
            put(project, broken.file, broken.text.toString());
        }
    }

    private void folders() throws IOException {
        put(folder("deep", "environment/o.xml", "nested more than 16 deep"), "environment/o.xml",
            "<Box>".repeat(150_000));
        put(folder("huge", "environment/o.xml", "at most 1048576 bytes"), "environment/o.xml", "<Box>" + " "
            .repeat(Xml.MAX_BYTES) + "</Box>");
        put(folder("laughs", "environment/o.xml", "document type"), "environment/o.xml",
            "<!DOCTYPE Box [<!ENTITY a \"aaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;\">]><Box><name>&b;</name></Box>");
        put(folder("many", "environment/o.xml", "<x> occurs once too often"), "environment/o.xml", "<Box>" + "<x>a</x>"
            .repeat(100_000) + "</Box>");
        put(folder("wide", "environment/o.xml"), "environment/o.xml", "<Box " + "a=\"1\" ".repeat(1000) + "/>");
        Files.createSymbolicLink(folder("endless", "environment/o.xml", "neither a link nor a folder")
            .resolve("environment/o.xml"), Path.of("/dev/zero"));
        Path crowd = folder("crowd of broken files", "environment/o0.xml", "is not an object here");
        for (int i = 0; i < 3000; i++) {
            put(crowd, "environment/o" + i + ".xml", "<Nonsense/>");
        }
    }

    private void good() throws IOException {
        put(folder("good", "no problems"), "environment/o.xml", BOX + "</Box>");
    }

    private List<String> check() throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(
            List.of(Paths.get(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(List.of(MEMORY));
        command.addAll(List.of("-Dfile.encoding=UTF-8", "-cp", System.getProperty("java.class.path"),
            CheckEach.class.getName(), temporary.getRoot().toPath().resolve("corpus").toString()));
        File out = temporary.newFile();
        File err = temporary.newFile();
        Process process = new ProcessBuilder(command).redirectOutput(out).redirectError(err).start();
        try {
            assertTrue("hangs at " + Files.readAllLines(out.toPath()).size(), process.waitFor(20, TimeUnit.MINUTES));
        } finally {
            process.destroyForcibly();
        }
        assertEquals(Files.readString(err.toPath()), 0, process.exitValue());
        return Files.readAllLines(out.toPath());
    }

    @Test
    public void eachEndsWithItsMessageInLittleTimeAndMemory() throws Exception {
        good();
        models();
        pictures();
        files();
        folders();
        assertTrue(count + " broken ones", count > LEAST);
        List<String> lines = check();
        assertEquals(count, lines.size());
        List<String> wrong = new ArrayList<>();
        for (String line : lines) {
            String[] parts = line.split("\t", 4);
            boolean good = parts[0].startsWith("000");
            if (!parts[1].equals(good ? "0" : "2") || Long.parseLong(parts[2]) > MOST_MILLIS || !parts[3].isEmpty()) {
                wrong.add(line);
            }
        }
        assertEquals(List.of(), wrong);
    }
}
