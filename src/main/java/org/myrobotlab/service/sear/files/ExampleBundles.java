package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.project.problems.ProjectException;

/** The example bundles inside the jar, by paths such as {@code examples/office.sear}, which hold in every working folder. Any thread. */
public final class ExampleBundles {
    private static final String FOLDER = "examples/";
    private static final String ENDING = ".sear";
    private static final String IN_JAR = "/resource/SEAR/";
    /** A name on each line, written by the build. */
    private static final String LIST = "/org/SEAR/examples.txt";

    /** What is done with a bundle's file. */
    public interface Work<T> {
        /** @throws ProjectException with every problem of the bundle */
        T on(Path bundle) throws IOException, ProjectException;
    }

    private ExampleBundles() {
    }

    /** Paths of all. */
    static List<String> paths() throws IOException {
        return list().stream().filter(name -> name.endsWith(ENDING)).map(name -> FOLDER + name).collect(Collectors.toList());
    }

    /** What the build has put into the jar: names below {@code examples}. */
    static List<String> list() throws IOException {
        try (InputStream in = ExampleBundles.class.getResourceAsStream(LIST)) {
            return in == null ? List.of() : Arrays.asList(new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n"));
        }
    }

    /**
     * Whether a bundle comes with SEAR.
     *
     * @param bundle the file
     * @param path by which it was asked for
     */
    static boolean isOne(Path bundle, Path path) throws IOException {
        String name = path.getFileName() == null ? "" : path.getFileName().toString();
        if (!paths().contains(FOLDER + name) || !Files.isRegularFile(bundle)) {
            return false;
        }
        try (InputStream in = ExampleBundles.class.getResourceAsStream(IN_JAR + name)) {
            return in != null && Arrays.equals(in.readAllBytes(), Files.readAllBytes(bundle));
        }
    }

    /** Whether a path means an example: there is no file of that name, and an example of it. */
    public static boolean isMeant(Path path) throws IOException {
        return !Files.exists(path) && paths().contains(name(path));
    }

    private static String name(Path path) {
        return path.toString().replace('\\', '/');
    }

    /** Gives somebody a bundle as a file: the one of that path; where there is none, the example of that path. */
    public static <T> T with(Path path, Work<T> work) throws IOException, ProjectException {
        if (!isMeant(path)) {
            return work.on(path);
        }
        Path file = Files.createTempFile("sear", ".sear");
        try (InputStream in = ExampleBundles.class.getResourceAsStream(IN_JAR + name(path).substring(FOLDER.length()))) {
            Files.write(file, in.readAllBytes());
            return work.on(file);
        } finally {
            Files.deleteIfExists(file);
        }
    }
}
