// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Slow;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** The Python 3 package writes files whole or not at all. */
@Category(Slow.class)
public class PythonFilesTest {
    private static final Path PACKAGE = Path.of(System.getProperty("sear.root", "."), "python/src/sear");
    private static final String SCRIPT = String.join("\n",
        "import importlib.util, os, sys",
        "spec = importlib.util.spec_from_file_location('files', sys.argv[1])",
        "files = importlib.util.module_from_spec(spec)",
        "spec.loader.exec_module(files)",
        "os.chdir(sys.argv[2])",
        "open('old', 'w').write('old')",
        "os.chmod('old', 0o600)",
        "try:",
        "    with files.whole('old') as aside, open(aside, 'w') as file:",
        "        file.write('half')",
        "        raise OSError('the disk is full')",
        "except OSError as error:",
        "    print(error, open('old').read(), os.listdir())",
        "with files.whole('old') as aside, open(aside, 'w') as file:",
        "    file.write('new')",
        "with files.whole('other') as aside, open(aside, 'w') as file:",
        "    file.write('new')",
        "print(open('old').read(), oct(os.stat('old').st_mode & 0o777), sorted(os.listdir()))",
        "with files.whole(os.devnull) as place:",
        "    print(place == os.devnull)",
        "try:",
        "    with files.whole('nowhere/file') as aside: pass",
        "except FileNotFoundError as error:",
        "    print(str(error).startswith(os.path.abspath('nowhere/file')))");

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    @Test
    public void aFileIsTheOldOneOrTheNewOne() throws Exception {
        Process python = new ProcessBuilder("python3", "-c", SCRIPT, PACKAGE.resolve("_files.py").toAbsolutePath()
            .toString(), temporary.getRoot().getPath()).redirectErrorStream(true).start();
        String printed = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(printed, 0, python.waitFor());
        assertEquals("the disk is full old ['old']\nnew 0o600 ['old', 'other']\nTrue\nTrue\n", printed);
    }

    @Test
    public void everyOtherWriterIsListed() throws IOException {
        try (Stream<Path> files = Files.walk(PACKAGE)) {
            Set<String> writers = files.filter(file -> file.toString().endsWith(".py")).flatMap(PythonFilesTest::lines)
                .filter(line -> line.matches(".*\\bopen\\([^)]*[\"'][wax][bt+]*[\"'].*")
                    && !line.contains("open(aside")).map(String::trim)
                .collect(Collectors.toSet());
            assertEquals("a run's own copy of a script, and a table beside its place",
                Set.of("with open(script, \"wb\") as file:", "with open(table, \"w\", encoding=\"utf-8\", "
                    + "newline=\"\") as file:"), writers);
        }
    }

    private static Stream<String> lines(Path file) {
        try {
            return Files.readAllLines(file).stream();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
