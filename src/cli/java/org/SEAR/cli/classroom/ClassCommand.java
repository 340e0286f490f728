package org.SEAR.cli.classroom;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.SEAR.project.problems.FileReasons;
import org.myrobotlab.embedded.web.Address;
import org.myrobotlab.embedded.web.Token;
import org.myrobotlab.service.sear.files.ExampleBundles;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code sear class --pupils NAMES.txt}: runs a SEAR for each pupil of a class. */
@Command(name = "class", mixinStandardHelpOptions = true,
    description = "Runs a SEAR for each pupil of a class: a process, a folder, a port, a link with a token and a limit of memory of one's own. What "
        + "ends is started again. docs/classroom.md says what one pupil can do to another.",
    footer = "Exit status: 0 after Ctrl+C, 2 when the command makes no sense.")
public final class ClassCommand implements Callable<Integer> {
    private static final int HIGHEST_PORT = 65535;
    private static final int MIN_MEMORY = 64;
    /** Memory of a Java process besides its heap, MB: classes, compiled code and threads, and a Python 3 with numpy. */
    private static final int BESIDES = 400;
    private static final String MAIN = "org.SEAR.cli.SearCommand";
    private static final String PRIVATE = "rwx------";

    @Option(names = "--pupils", paramLabel = "NAMES.txt", required = true, description = "The pupils' names, one a line.")
    private Path names;
    @Option(names = "--port", paramLabel = "N", defaultValue = "8901", description = "Port of the first pupil; the others have the following ones. "
        + "Default: ${DEFAULT-VALUE}.")
    private int port;
    @Option(names = "--host", paramLabel = "ADDRESS", description = "Let other computers in: an address of this computer, or 0.0.0.0 for all that "
        + "it has. Default: this computer alone.")
    private String host;
    @Option(names = "--url", paramLabel = "URL", description = "How browsers reach a pupil's SEAR, if otherwise: {port} and {name} become the "
        + "pupil's port and folder, as in https://{name}.school.example or http://school.example:{port}.")
    private String url;
    @Option(names = "--memory", paramLabel = "MB", defaultValue = "256", description = "What the robots and scripts of one pupil may hold in memory. "
        + "Default: ${DEFAULT-VALUE}.")
    private int memory;
    @Option(names = "--total-memory", paramLabel = "MB", description = "What one pupil's process may hold with all that it has started (Linux). "
        + "Default: " + BESIDES + " more than --memory.")
    private Integer total;
    @Option(names = "--folder", paramLabel = "FOLDER", defaultValue = "class", description = "Holds a folder for each pupil, the links and what the "
        + "programs print. Default: ${DEFAULT-VALUE}.")
    private Path folder;
    @Option(names = "--script", paramLabel = "FILE.py", description = "A script to begin with, copied to each pupil who has no file of that name "
        + "yet.")
    private Path script;
    @Option(names = "--project", paramLabel = "FILE.sear", description = "A project to begin with, for each pupil who has none yet; examples "
        + "are found anywhere.")
    private Path project;
    @Option(names = "--at-once", paramLabel = "N", description = "How many start at the same time. Default: as many as there are processors.")
    private Integer atOnce;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        PrintWriter out = spec.commandLine().getOut();
        Classroom classroom;
        try {
            List<Pupil> pupils = pupils();
            Path links = Token.writePrivate(folder.resolve("links.csv"), csv(pupils));
            int width = pupils.stream().mapToInt(pupil -> pupil.name.length()).max().orElse(1);
            pupils.forEach(pupil -> out.println(String.format("%-" + width + "s  %s", pupil.name, pupil.link)));
            out.println("These links are in " + links + ", too, which only you can read.");
            if (!Address.current().isLoopback()) {
                out.println("Other computers reach them. What they send is not encrypted: docs/classroom.md says what to do about it.");
            }
            out.flush();
            classroom = new Classroom(pupils, atOnce == null ? Runtime.getRuntime().availableProcessors() : atOnce,
                total == null ? memory + BESIDES : total, out);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        } catch (IOException e) {
            throw new ParameterException(spec.commandLine(), FileReasons.of(e), e);
        }
        Runtime.getRuntime().addShutdownHook(new Thread(classroom::end, "end of the class"));
        Thread teacher = new Thread(() -> listen(classroom), "teacher");
        teacher.setDaemon(true);
        teacher.start();
        classroom.run();
        return ExitCode.OK;
    }

    private void check(int count) throws IOException {
        int last = port + count - 1;
        if (port < 1 || last > HIGHEST_PORT) {
            throw new IllegalArgumentException("--port is " + port + ", the last of " + count + " pupils would have " + last + ", legal: 1 to "
                + HIGHEST_PORT);
        }
        if (memory < MIN_MEMORY) {
            throw new IllegalArgumentException("--memory is " + memory + ", legal: " + MIN_MEMORY + " or more");
        }
        if (total != null && total < memory) {
            throw new IllegalArgumentException("--total-memory is " + total + ", legal: " + memory + ", as --memory, or more");
        }
        if (atOnce != null && atOnce < 1) {
            throw new IllegalArgumentException("--at-once is " + atOnce + ", legal: 1 or more");
        }
        if (url != null && count > 1 && !url.contains("{port}") && !url.contains("{name}")) {
            throw new IllegalArgumentException("--url is " + url + ", the same for " + count + " pupils, legal: with {port} or {name} in it");
        }
        for (Path file : new Path[] {script, project}) {
            if (file != null && !Files.isRegularFile(file) && !(file == project && ExampleBundles.isMeant(file))) {
                throw new IllegalArgumentException(file + " can't be read: there is no such file");
            }
        }
    }

    private List<Pupil> pupils() throws IOException {
        Map<String, String> roster = Roster.read(names);
        check(roster.size());
        boolean isNew = Files.notExists(folder);
        Path tokens = Files.createDirectories(folder.resolve(".tokens"));
        Path logs = Files.createDirectories(folder.resolve(".logs"));
        if (Files.getFileAttributeView(folder, PosixFileAttributeView.class) != null) {
            for (Path one : isNew ? List.of(folder, tokens, logs) : List.of(tokens, logs)) {
                Files.setPosixFilePermissions(one, PosixFilePermissions.fromString(PRIVATE));
            }
        }
        List<Pupil> pupils = new ArrayList<>();
        for (Map.Entry<String, String> one : roster.entrySet()) {
            int own = port + pupils.size();
            Path token = tokens.resolve(one.getValue());
            if (Files.notExists(token)) {
                Token.writePrivate(token, Token.make() + "\n");
            }
            Address address = Address.listen(host, url == null ? null : url.replace("{name}", one.getValue()));
            Path place = Files.createDirectories(folder.resolve(one.getValue()));
            if (script != null && Files.notExists(place.resolve(script.getFileName()))) {
                Files.copy(script, place.resolve(script.getFileName()));
            }
            pupils.add(new Pupil(one.getKey(), place, own, address.url(own) + "/?token=" + Files.readString(token).trim(),
                command(own, token, one.getValue(), Files.exists(place.resolve("SEARproject"))), address.socket(own),
                logs.resolve(one.getValue() + ".log")));
        }
        return pupils;
    }

    /** Returns this program's Java command with its options, except those that limit memory. */
    private List<String> command(int own, Path token, String name, boolean hasProject) throws IOException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(option -> !option.matches("-Xm[xs].*|-XX:Max.*|-agentlib.*|-javaagent.*|-Dsear.parent.*")).collect(Collectors.toList()));
        command.addAll(List.of("-Xms16m", "-Xmx" + memory + "m", "-XX:+ExitOnOutOfMemoryError", "-XX:MaxMetaspaceSize=192m",
            "-XX:MaxDirectMemorySize=64m", "-XX:ReservedCodeCacheSize=96m", "-Dsear.parent=" + ProcessHandle.current().pid()));
        command.addAll(List.of("-cp", absolute(System.getProperty("java.class.path")), MAIN, "--headless", "--threads", "1", "--port",
            String.valueOf(own), "--token-file", token.toAbsolutePath().toString()));
        if (host != null) {
            command.addAll(List.of("--host", host));
        }
        if (url != null) {
            command.addAll(List.of("--url", url.replace("{name}", name)));
        }
        if (project != null && !hasProject) {
            command.add((ExampleBundles.isMeant(project) ? project : project.toAbsolutePath()).toString());
        }
        return command;
    }

    /** Makes the paths absolute, because the program runs in another folder. */
    private static String absolute(String classPath) {
        List<String> paths = new ArrayList<>();
        for (String one : classPath.split(java.io.File.pathSeparator)) {
            boolean isAll = one.endsWith("*");
            paths.add(Path.of(isAll ? one.substring(0, one.length() - 1) : one).toAbsolutePath() + (isAll ? java.io.File.separator + "*" : ""));
        }
        return String.join(java.io.File.pathSeparator, paths);
    }

    private static String csv(List<Pupil> pupils) {
        return "name,link\n" + pupils.stream().map(pupil -> "\"" + pupil.name.replace("\"", "\"\"") + "\"," + pupil.link + "\n")
            .collect(Collectors.joining());
    }

    private static void listen(Classroom classroom) {
        try (BufferedReader in = new BufferedReader(new InputStreamReader(System.in, Charset.defaultCharset()))) {
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                classroom.hear(line);
            }
        } catch (IOException e) {
            return;    // no terminal
        }
    }
}
