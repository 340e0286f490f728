// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;
import static org.junit.Assume.assumeTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import javax.xml.parsers.DocumentBuilderFactory;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.w3c.dom.NodeList;

/** {@code sear grade} of hostile scripts among good ones. */
@Category(Slow.class)
public class HostileScriptsTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String START =
        "import os, shutil\nsear = Runtime.start(\"sear\", \"SEAR\")\nsear.startSimulation()\nsear.simSleep(1)\n";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private String grade(int status, String what, String out) throws Exception {
        List<String> words = SearProcess.command("-Xmx256m", "-Dsear.home=" + ROOT);
        words.addAll(List.of("grade", what, "--lesson", "square", "--out", out, "--jobs", "2"));
        File said = folder.newFile();
        words.add(0, "setsid");     // a signal that gets through ends this command, not the test
        Process process = new ProcessBuilder(words).directory(folder.getRoot()).redirectErrorStream(true)
            .redirectOutput(said).start();
        try {
            assertTrue("sear grade hangs", process.waitFor(600, TimeUnit.SECONDS));
        } finally {
            process.destroy();
        }
        String text = Files.readString(said.toPath());
        assertEquals(text, status, process.exitValue());
        return text;
    }

    private Map<String, String> rows(String out) throws Exception {
        Map<String, String> rows = new TreeMap<>();
        for (String line : Files.readAllLines(folder.getRoot().toPath().resolve(out).resolve("marks.csv"))) {
            rows.put(line.split(",")[0], line);
        }
        return rows;
    }

    private void handIn(String pupil, String script) throws Exception {
        Files.writeString(folder.getRoot().toPath().resolve("handed-in").resolve(pupil + ".py"), script);
    }

    @Test
    public void hostileScriptsCostOnlyTheirOwnMarks() throws Exception {
        assumeTrue(Files.isReadable(Path.of("/proc/self/environ")));
        folder.newFolder("handed-in");
        Path id = folder.getRoot().toPath().resolve("id");
        String right = Files.readString(ROOT.resolve("solutions/square.py"));
        handIn("deletes", START + "shutil.rmtree(os.path.dirname(os.getcwd()))\n");
        handIn("escapes", START + "raise ValueError('\\x1b]0;title\\x07red')\n");
        handIn("leaves", START + "os.system(\"setsid sh -c 'echo $$ > " + id
            + "; while echo x >> left.txt; do sleep 0.01; done' &\")\nwhile not os.path.exists('left.txt'): pass\n");
        handIn("nests", START
            + "deep = os.getcwd()\nfor i in range(400):\n    deep += '/d'\n    os.mkdir(deep)\nos.chmod(deep, 0)\n");
        handIn("ends", START + "os.kill(os.getppid(), 15)\nwhile True: pass\n");
        handIn("ends2", START + "os.kill(os.getppid(), 9)\nwhile True: pass\n");
        handIn("ends3", START + "os.system('kill -9 0')\nwhile True: pass\n");
        handIn("right", right);
        handIn("right2", right);
        String text = grade(1, "handed-in", "all");
        Map<String, String> rows = rows("all");
        List<String> pupils = new ArrayList<>(List.of("deletes", "ends", "ends2", "ends3", "escapes", "leaves",
            "nests", "pupil", "right", "right2"));
        assertEquals(text, pupils, new ArrayList<>(rows.keySet()));
        assertTrue(text, rows.get("right").startsWith("right,square,passed,7,7,"));
        assertEquals(rows.get("right").replaceFirst("right", "right2"), rows.get("right2"));
        assertTrue(text, rows.get("leaves").startsWith("leaves,square,not yet,"));
        assertTrue(text, rows.get("ends").startsWith("ends,square,error,"));
        assertTrue(text, rows.get("ends2").startsWith("ends2,square,error,"));
        assertTrue(text, rows.get("ends3").startsWith("ends3,square,error,"));
        assertTrue(text, rows.get("escapes").contains("ValueError: ?]0;title?red"));
        assertTrue(text, text.contains("ValueError: ?]0;title?red"));
        assertFalse(text, text.chars().anyMatch(c -> c == 0x1b || c == 0x07));
        Path left = Path.of("/proc", Files.readString(id).trim(), "stat");
        assertTrue("the process left behind runs", !Files.exists(left) || Files.readString(left).contains(") Z "));
        NodeList cases = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(new File(folder.getRoot(), "all/marks.xml")).getElementsByTagName("testcase");
        assertEquals(9, cases.getLength());
        assertTrue(text,
            Files.readString(folder.getRoot().toPath().resolve("all/marks.txt")).contains("2 of 9 have passed"));
        grade(0, "handed-in/right.py", "alone");
        assertEquals(rows.get("right").replaceFirst("right,square,passed,7,7,", ""),
            rows("alone").get("right").replaceFirst("right,square,passed,7,7,", ""));
    }
}
