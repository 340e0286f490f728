// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.SEAR.POJOs.Box;
import org.SEAR.Slow;
import org.SEAR.files.AtomicFile;
import org.SEAR.plot.Plot;
import org.SEAR.project.bundle.Bundle;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.sear.files.Projects;

/**
 * A process with a limit on the size of files: the system rejects further writes in the middle of a file, like a full
 * disk. Existing files stay whole, and no half-written file remains.
 */
@Category(Slow.class)
public class DiskFullTest {
    /** Limit of a file, blocks of 512 bytes. */
    private static final int LIMIT = 600;
    /** Limit below the size of a template, blocks. */
    private static final int LITTLE = 4;
    private static final int TOO_MUCH = 500_000;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Tries to save, to load and to write one object's file, or only to copy a template, and prints each result. */
    public static void main(String[] arguments) throws Exception {
        Path root = Paths.get(arguments[1]);
        if (Integer.parseInt(arguments[0]) == LITTLE) {
            attempt("template", () -> new Projects(null, null).copyTemplate("controller.py", root.toString()));
            attempt("plot", () -> plot(100).save(root.resolve("plot.svg")));
            return;
        }
        attempt("save", () -> Bundle.save(root.resolve("big"), root.resolve("old.sear")));
        attempt("load", () -> Bundle.load(root.resolve("big.sear"), root.resolve("SEARproject")));
        attempt("object", () -> AtomicFile.write(root.resolve("SEARproject/environment/box.xml"), new byte[TOO_MUCH]));
        attempt("small", () -> Bundle.save(root.resolve("SEARproject"), root.resolve("new.sear")));
    }

    /** An action that may fail. */
    private interface Deed {
        void run() throws Exception;
    }

    private static void attempt(String what, Deed deed) throws Exception {
        try {
            deed.run();
            System.out.println(what + " done");
        } catch (IOException e) {
            System.out.println(what + " refused: " + e.getClass().getSimpleName());
        }
    }

    private static Plot plot(int points) {
        Plot plot = new Plot("time (s)", IntStream.range(0, points).asDoubleStream().toArray());
        plot.add("x", "m", IntStream.range(0, points).mapToDouble(Math::sqrt).toArray());
        return plot;
    }

    private Path big() throws IOException {
        new Box("large", 1, 1, 1, 0);
        byte[] noise = new byte[TOO_MUCH];
        new Random(1).nextBytes(noise);
        project.put("assets/noise.bin", "");
        Files.write(project.folder().resolve("assets/noise.bin"), noise);
        return Files.move(project.folder(), project.getRoot().toPath().resolve("big"));
    }

    private String runLimited(int limit) throws IOException, InterruptedException {
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        Process process = new ProcessBuilder("sh", "-c", "ulimit -f " + limit + "; exec \"$0\" \"$@\"", java,
            "-XX:-UsePerfData", "-Xshare:auto", "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"),
            DiskFullTest.class.getName(), String.valueOf(limit), project.getRoot().getPath())
            .redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(said, 0, process.waitFor());
        return said;
    }

    @Test
    public void existingFilesStayWhole() throws Exception {
        Path root = project.getRoot().toPath();
        Bundle.save(big(), root.resolve("big.sear"));
        new Box("box", 1, 1, 1, 0);
        Bundle.save(project.folder(), root.resolve("old.sear"));
        byte[] bundle = Files.readAllBytes(root.resolve("old.sear"));
        Map<String, String> files = project.files();
        Set<String> names = names(root);

        assertEquals("save refused: IOException\nload refused: IOException\nobject refused: IOException\nsmall done\n",
            runLimited(LIMIT));

        assertArrayEquals(bundle, Files.readAllBytes(root.resolve("old.sear")));
        assertArrayEquals(bundle, Files.readAllBytes(root.resolve("new.sear")));
        assertEquals(files, project.files());
        names.add("new.sear");
        Set<String> left = names(root);
        left.remove(".SEARproject.lock");
        assertEquals(names, left);
    }

    @Test
    public void noHalfTemplateOrPlotIsLeft() throws Exception {
        Path root = project.getRoot().toPath();
        plot(2).save(root.resolve("plot.svg"));
        byte[] good = Files.readAllBytes(root.resolve("plot.svg"));
        Set<String> names = names(root);
        assertEquals("template refused: IOException\nplot refused: IOException\n", runLimited(LITTLE));
        assertEquals(names, names(root));
        assertArrayEquals(good, Files.readAllBytes(root.resolve("plot.svg")));
    }

    private static Set<String> names(Path folder) {
        return new TreeSet<>(Set.of(folder.toFile().list()));
    }
}
