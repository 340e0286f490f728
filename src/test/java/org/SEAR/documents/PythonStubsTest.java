// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.Slow;
import org.junit.BeforeClass;
import org.junit.ClassRule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Names and hints of the Python 3 package match the services' javadoc and the classes. */
@Category(Slow.class)
public class PythonStubsTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", "."));
    @ClassRule
    public static final TemporaryFolder TEMPORARY = new TemporaryFolder();
    private static final Path PACKAGE = ROOT.resolve("python/src/sear");
    private static String hints;
    private static Path file;

    @BeforeClass
    public static void generate() throws IOException {
        hints = new PythonStubs(ROOT).hints();
        file = Files.writeString(TEMPORARY.newFile("__init__.pyi").toPath(), hints);
    }

    @Test
    public void namesAreUpToDate() throws IOException {
        assertEquals("run gradle pythonNames", new PythonStubs(ROOT).names(),
            Files.readString(PACKAGE.resolve("_names.py")));
    }

    @Test
    public void hintsHaveTypes() {
        assertTrue(hints, hints.contains("    def getLidarResult(self, name: str) -> np.ndarray:\n"));
        assertTrue(hints, hints.contains("(self, name: str, length: float, width: float, height: float, mass: float) "
            + "-> None: ...\n"));
    }

    /** Without these names, {@code from sear import *} imports nothing for a type checker. */
    @Test
    public void theHintsHaveAllNamesOfAStarImport() throws IOException, InterruptedException {
        Process python = new ProcessBuilder("python3", "-c", "import ast, sys\ndef made(path):\n"
            + "    tree = ast.parse(open(path).read())\n    words = []\n    for one in tree.body:\n"
            + "        target = one.targets[0] if isinstance(one, ast.Assign) else getattr(one, 'target', None)\n"
            + "        if getattr(target, 'id', '') in ('__all__', 'OBJECTS'):\n"
            + "            words += [word.value for word in ast.walk(one.value) if isinstance(word, ast.Constant)]\n"
            + "    return words, [one.name for one in tree.body if hasattr(one, 'name')]\n"
            + "hints, defined = made(sys.argv[1])\nassert hints == made(sys.argv[2])[0] + made(sys.argv[3])[0], hints\n"
            + "assert set(hints) <= set(defined) | {'python'}, set(hints) - set(defined)",
            file.toString(), PACKAGE.resolve("__init__.py").toString(), PACKAGE.resolve("_names.py").toString())
            .redirectErrorStream(true).start();
        assertEquals("", new String(python.getInputStream().readAllBytes()));
        assertEquals(0, python.waitFor());
    }

    /** Python itself parses the hints. */
    @Test
    public void theHintsAreAPythonModule() throws IOException, InterruptedException {
        Process python = new ProcessBuilder(
            "python3", "-c", "import ast, sys; tree = ast.parse(open(sys.argv[1]).read());"
            + " names = [one.name for one in tree.body if isinstance(one, ast.ClassDef)]; assert len(names) == "
            + "len(set(names)), names", file.toString()).redirectErrorStream(true).start();
        assertEquals("", new String(python.getInputStream().readAllBytes()));
        assertEquals(0, python.waitFor());
    }
}
