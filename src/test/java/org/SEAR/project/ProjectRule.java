// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.rules.TemporaryFolder;

/** An empty present project for each test; objects that the test creates write their files there. */
public class ProjectRule extends TemporaryFolder {
    private String before;

    @Override
    protected void before() throws Throwable {
        super.before();
        before = System.getProperty("sear.project");
        System.setProperty("sear.project", folder().toString());
    }

    @Override
    protected void after() {
        if (before == null) {
            System.clearProperty("sear.project");
        } else {
            System.setProperty("sear.project", before);
        }
        super.after();
    }

    /** Makes something with objects whose files no test reads, in a project that no other test process uses. */
    public static <T> T unread(Supplier<T> maker) {
        String before = System.getProperty("sear.project");
        System.setProperty("sear.project", System.getProperty("java.io.tmpdir") + "/sear-" + ProcessHandle.current()
            .pid() + "/SEARproject");
        try {
            return maker.get();
        } finally {
            if (before == null) {
                System.clearProperty("sear.project");
            } else {
                System.setProperty("sear.project", before);
            }
        }
    }

    /** Returns the SEARproject folder, which the first object creates. */
    public Path folder() {
        return getRoot().toPath().resolve("SEARproject");
    }

    public String text(String file) throws IOException {
        return new String(Files.readAllBytes(folder().resolve(file)), StandardCharsets.UTF_8);
    }

    /** Writes a file of the project as a user would. */
    public void put(String file, String text) throws IOException {
        Path path = folder().resolve(file);
        Files.createDirectories(path.getParent());
        Files.write(path, text.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the files of the project: content by path. */
    public Map<String, String> files() throws IOException {
        return files(folder());
    }

    /** Returns the files of a folder: content by path, one character per byte. */
    public static Map<String, String> files(Path folder) throws IOException {
        Map<String, String> files = new TreeMap<>();
        if (Files.isDirectory(folder)) {
            try (Stream<Path> all = Files.walk(folder)) {
                for (Path file : (Iterable<Path>) all.filter(Files::isRegularFile)::iterator) {
                    String name = folder.relativize(file).toString().replace('\\', '/');
                    files.put(name, new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1));
                }
            }
        }
        return files;
    }
}
