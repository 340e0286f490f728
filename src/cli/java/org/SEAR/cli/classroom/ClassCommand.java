// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.classroom;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.SEAR.files.AtomicFile;
import org.SEAR.files.PrintableText;
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
    description = "Runs a SEAR for each pupil of a class, with its own process, folder, port, link with a token, and "
    + "memory limit. A SEAR that ends is restarted. docs/classroom.md says what pupils can do to each other.",
    footer = "Exit status: 0 after Ctrl+C, 2 for an invalid command.")
public final class ClassCommand implements Callable<Integer> {
    private static final int HIGHEST_PORT = 65535;
    private static final int MIN_MEMORY = 64;
    /** Memory of a Java process besides its heap, MB: classes, compiled code and threads, and a Python 3 with numpy. */
    private static final int BESIDES = 400;
    private static final String MAIN = "org.SEAR.cli.SearCommand";
    private static final String PRIVATE = "rwx------";

    @Option(names = "--pupils", paramLabel = "NAMES.txt", required = true, description = "A file with the pupils' "
        + "names, one per line.")
    private Path names;
    @Option(names = "--port", paramLabel = "N", defaultValue = "8901", description = "Port of the first pupil; the "
        + "others get the next ones. Default: ${DEFAULT-VALUE}.")
    private int port;
    @Option(names = "--host", paramLabel = "ADDRESS", description = "Let other computers connect: an address of this "
        + "computer, or 0.0.0.0 for all of them. Default: this computer only.")
    private String host;
    @Option(names = "--url", paramLabel = "URL", description = "Address of a pupil's SEAR for browsers, if different: "
        + "{port} and {name} become the "
        + "pupil's port and folder, as in https://{name}.school.example or http://school.example:{port}.")
    private String url;
    @Option(names = "--memory", paramLabel = "MB", defaultValue = "256", description = "Memory limit of one pupil's "
        + "robots and scripts. Default: ${DEFAULT-VALUE}.")
    private int memory;
    @Option(names = "--total-memory", paramLabel = "MB", description = "Memory limit of one pupil's process with all "
        + "that it starts (Linux). Default: " + BESIDES + " more than --memory.")
    private Integer total;
    @Option(names = "--folder", paramLabel = "FOLDER", defaultValue = "class",
        description = "Folder for the pupils' folders, the links and the programs' output. Default: ${DEFAULT-VALUE}.")
    private Path folder;
    @Option(names = "--script", paramLabel = "FILE.py", description = "An initial script, copied to each pupil without "
        + "a file of that name.")
    private Path script;
    @Option(names = "--project", paramLabel = "FILE.sear", description = "An initial project for each pupil without "
        + "one; examples are found from any folder.")
    private Path project;
    @Option(names = "--at-once", paramLabel = "N", description = "Programs that start at the same time. Default: the "
        + "number of processors.")
    private Integer atOnce;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        PrintWriter out = PrintableText.writer(spec.commandLine().getOut());
        Classroom classroom;
        try {
            List<Pupil> pupils = pupils();
            Path links = Token.writePrivate(folder.resolve("links.csv"), csv(pupils));
            int width = pupils.stream().mapToInt(pupil -> pupil.name.length()).max().orElse(1);
            pupils.forEach(pupil -> out.println(String.format("%-" + width + "s  %s", pupil.name, pupil.link)));
            out.println("The links are also in " + links + ", which only you can read.");
            if (!Address.current().isLoopback()) {
                out.println("Other computers can reach them. The connection is not encrypted: see docs/classroom.md.");
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
            throw new IllegalArgumentException("--port is " + port + ", so the last of " + count + " pupils would get "
                + last + ", legal: 1 to " + HIGHEST_PORT);
        }
        if (memory < MIN_MEMORY) {
            throw new IllegalArgumentException("--memory is " + memory + ", legal: " + MIN_MEMORY + " or more");
        }
        if (total != null && total < memory) {
            throw new IllegalArgumentException("--total-memory is " + total + ", legal: " + memory
                + " (--memory) or more");
        }
        if (atOnce != null && atOnce < 1) {
            throw new IllegalArgumentException("--at-once is " + atOnce + ", legal: 1 or more");
        }
        if (url != null && count > 1 && !url.contains("{port}") && !url.contains("{name}")) {
            throw new IllegalArgumentException("--url is " + url + ", the same for " + count
                + " pupils, legal: with {port} or {name} in it");
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
                AtomicFile.write(place.resolve(script.getFileName()),
                    copy -> Files.copy(script, copy, StandardCopyOption.REPLACE_EXISTING));
            }
            pupils.add(new Pupil(one.getKey(), place, own, address.url(own) + "/?token="
                + Files.readString(token).trim(),
                command(own, token, one.getValue(), Files.exists(place.resolve("SEARproject"))), address.socket(own),
                logs.resolve(one.getValue() + ".log")));
        }
        return pupils;
    }

    /** Returns this program's Java command with its options, except those that limit memory. */
    private List<String> command(int own, Path token, String name, boolean hasProject) throws IOException {
        List<String> command = new ArrayList<>(
            List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(option -> !option.matches("-Xm[xs].*|-XX:Max.*|-agentlib.*|-javaagent.*|-Dsear.parent.*"))
                .collect(Collectors.toList()));
        command.addAll(List.of("-Xms16m", "-Xmx" + memory + "m", "-XX:+ExitOnOutOfMemoryError",
            "-XX:MaxMetaspaceSize=192m",
            "-XX:MaxDirectMemorySize=64m", "-XX:ReservedCodeCacheSize=96m", "-Dsear.parent="
                + ProcessHandle.current().pid()));
        command.addAll(List.of("-cp", absolute(System.getProperty("java.class.path")), MAIN, "--headless", "--threads",
            "1", "--port", String.valueOf(own), "--token-file", token.toAbsolutePath().toString()));
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
            paths.add(Path.of(isAll ? one.substring(0, one.length() - 1) : one).toAbsolutePath()
                + (isAll ? java.io.File.separator + "*" : ""));
        }
        return String.join(java.io.File.pathSeparator, paths);
    }

    private static String csv(List<Pupil> pupils) {
        return "name,link\n" + pupils.stream().map(pupil -> "\"" + pupil.name.replace("\"", "\"\"") + "\","
            + pupil.link + "\n").collect(Collectors.joining());
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
