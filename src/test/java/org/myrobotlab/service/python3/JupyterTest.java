// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.python3;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** SEAR in notebooks: scripts of src/test/jupyter, the notebook of the examples, programs of docs/notebooks.md. */
@Category(Slow.class)
@Needs({"installDist", "python3", "numpy1", "jupyter"})
public class JupyterTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final Path SCRIPTS = ROOT.resolve("src/test/jupyter");
    private static final Path NOTEBOOK = ROOT.resolve("examples/python3/first_steps.ipynb");
    private static final String LIBRARIES = System.getProperty("sear.python3");
    private static final String JUPYTER = System.getProperty("sear.jupyter");
    private static final String HOME = System.getProperty("sear.home.built", ROOT.resolve("build/install/sear")
        .toString());
    private static final long PATIENCE_MINUTES = 10;
    private static final String SVG = "image/svg+xml";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    /** Returns a program's output, run in a new folder with these packages and SEAR's own. */
    private String run(List<String> packages, String... words) throws IOException, InterruptedException {
        Path folder = temporary.newFolder().toPath();
        File output = temporary.newFile();
        List<String> command = new ArrayList<>(List.of("python3"));
        command.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(output);
        List<String> modules = new ArrayList<>(packages);
        modules.add(ROOT.resolve("python/src").toString());
        modules.add(LIBRARIES);
        builder.environment().put("PYTHONPATH", String.join(File.pathSeparator, modules));
        builder.environment().put("SEAR_HOME", HOME);
        builder.environment().put("IPYTHONDIR", folder.resolve(".ipython").toString());
        builder.environment().put("JUPYTER_PREFER_ENV_PATH", "0");
        Process process = builder.start();
        try {
            assertTrue("it has not ended:\n" + Files.readString(output.toPath()),
                process.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES));
        } finally {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
        assertEquals(Files.readString(output.toPath()), 0, process.exitValue());
        return Files.readString(output.toPath());
    }

    private static List<JsonNode> outputs(Path notebook) throws IOException {
        List<JsonNode> outputs = new ArrayList<>();
        for (JsonNode cell : new ObjectMapper().readTree(notebook.toFile()).get("cells")) {
            cell.path("outputs").forEach(outputs::add);
        }
        return outputs;
    }

    private static String text(JsonNode lines) {
        StringBuilder text = new StringBuilder(lines.isTextual() ? lines.asText() : "");
        lines.forEach(line -> text.append(line.asText()));
        return text.toString();
    }

    /**
     * Runs the cells twice in one kernel. The second output equals the file's, except for camera pictures, which only
     * need to be present.
     */
    @Test
    public void theNotebookReproducesItsOutputs() throws Exception {
        Path result = temporary.getRoot().toPath().resolve("result.ipynb");
        run(List.of(JUPYTER), SCRIPTS.resolve("run_notebook.py").toString(), NOTEBOOK.toString(), temporary.newFolder()
            .toString(), result.toString(), "2");
        List<JsonNode> there = outputs(NOTEBOOK);
        List<JsonNode> now = outputs(result);
        String renew = "if it is as it is to be: ./gradlew notebooks";
        assertEquals(renew, there.size(), now.size());
        int pictures = 0;
        for (int i = 0; i < now.size(); i++) {
            JsonNode data = now.get(i).path("data");
            assertFalse(now.get(i).toString(), now.get(i).path("output_type").asText().equals("error"));
            assertEquals(renew, text(there.get(i).path("text")), text(now.get(i).path("text")));
            assertEquals(renew, text(there.get(i).path("data").path(SVG)), text(data.path(SVG)));
            assertEquals(renew, there.get(i).path("data").has("image/png"), data.has("image/png"));
            pictures += data.has(SVG) || data.has("image/png") ? 1 : 0;
        }
        assertEquals("two plans, a scan, a picture, two plots", 6, pictures);
        String all = now.toString();
        assertTrue(all, all.contains("rover 0\u00b0")
            && all.contains("scanner: 181 beams, the nearest 1.13 m, straight ahead"));
    }

    @Test
    public void anInterruptAbortsAWait() throws Exception {
        String said = run(List.of(JUPYTER), SCRIPTS.resolve("interrupted.py").toString());
        for (String wait : List.of("simSleep(1000000) at speed max", "step(10000000) at speed max",
            "simSleep(1000000) at speed 5", "time.sleep(1000000) at speed 5")) {
            assertTrue(said, said.contains(wait + " was interrupted\n"));
        }
        assertTrue(said, said.endsWith("SIGTERM has ended the kernel\n"));
    }

    @Test
    public void objectsAlwaysHaveADisplay() throws Exception {
        for (List<String> numpy : List.of(List.<String>of(), List.of(System.getProperty("sear.numpy1")))) {
            String said = run(numpy, SCRIPTS.resolve("pictures.py").toString());
            assertTrue(said, said.endsWith("all shown\n"));
        }
    }

    @Test
    public void thePagesProgramRuns() throws Exception {
        List<String> blocks = DocBlock.of("docs/notebooks.md", "python3");
        assertEquals(1, blocks.size());
        Path script = Files.writeString(temporary.newFile().toPath(), blocks.get(0)
            + "import os\nassert os.path.getsize('plan.svg') and os.path.getsize('plan.png') and "
                + "os.path.getsize('run.png')\n");
        run(List.of(), script.toString());
    }
}
