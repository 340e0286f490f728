// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.SEAR.lessons.LessonRun;
import org.SEAR.project.Project;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.ProjectException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Marks scripts, several in parallel. No script changes another one's mark. */
final class Marking {
    private static final Logger LOG = LoggerFactory.getLogger(Marking.class);
    private static final String RECORD = "run.searlog";
    private static final double AFTER = 1;

    private final double limit;
    private final int memory;
    private final long seed;
    private final boolean python3;
    private final Map<String, LessonCheck> checks = new HashMap<>();

    /**
     * @param limit processor time and idle time of each script, s
     * @param memory limit for each script, MB
     * @param python3 whether all scripts are Python 3
     */
    Marking(double limit, int memory, long seed, boolean python3) {
        this.limit = limit;
        this.memory = memory;
        this.seed = seed;
        this.python3 = python3;
    }

    /**
     * Marks scripts.
     *
     * @param jobs number of scripts marked in parallel
     * @param done gets each mark when it is ready, and all marks until then in the order of the scripts; one call at a
     *     time
     * @return the marks, in the order of the scripts
     */
    List<Mark> all(List<Submission> submissions, int jobs, BiConsumer<Mark, List<Mark>> done) throws IOException,
        InterruptedException {
        for (Submission one : submissions) {
            if (!checks.containsKey(one.lesson.getName())) {
                checks.put(one.lesson.getName(), new LessonCheck(one.lesson));
            }
        }
        ExecutorService workers = Executors.newFixedThreadPool(jobs);
        try {
            Map<Integer, Mark> marks = new TreeMap<>();
            List<Future<?>> futures = new ArrayList<>();
            for (int i = 0; i < submissions.size(); i++) {
                int number = i;
                futures.add(workers.submit(() -> {
                    Mark mark = mark(submissions.get(number));
                    synchronized (marks) {
                        marks.put(number, mark);
                        done.accept(mark, List.copyOf(marks.values()));
                    }
                    return mark;
                }));
            }
            for (Future<?> future : futures) {
                future.get();
            }
            return List.copyOf(marks.values());
        } catch (ExecutionException e) {
            throw new IOException(e.getCause().toString(), e);
        } finally {
            workers.shutdownNow();
        }
    }

    private Mark mark(Submission of) throws InterruptedException {
        if (of.script == null) {
            return new Mark(of, Mark.Kind.NOTHING, 0, 0,
                List.of("There is no script " + of.lesson.getName() + ".py."), Map.of());
        }
        try {
            return inFolders(of);
        } catch (IOException | ProjectException | RuntimeException | StackOverflowError | OutOfMemoryError e) {
            LOG.debug("{} of {} could not be marked", of.script, of.pupil, e);
            String reason = e instanceof IOException ? FileReasons.of((IOException) e) : e.toString();
            return new Mark(of, Mark.Kind.UNMARKED, 0, 0, List.of("SEAR could not mark your script: " + reason),
                Map.of());
        }
    }

    private Mark inFolders(Submission of) throws IOException, InterruptedException, ProjectException {
        try (ScratchFolder pupils = ScratchFolder.create("sear-mark"); ScratchFolder checks =
            ScratchFolder.create("sear-check")) {
            return mark(of, pupils.path(), checks.path());
        }
    }

    /**
     * Marks one script.
     *
     * @param folder of the script, which may delete or fill it
     * @param own folder of the check
     */
    private Mark mark(Submission of, Path folder, Path own) throws IOException, InterruptedException, ProjectException {
        LessonCheck check = checks.get(of.lesson.getName());
        Path run = Files.createDirectory(folder.resolve("run"));
        of.lesson.unpack(run);
        String script = of.lesson.script().getFileName().toString();
        copy(of, run, script);
        Path record = folder.resolve(RECORD);
        List<String> arguments = new ArrayList<>(
            List.of(script, "--headless", "--speed", "max", "--seed", Long.toString(seed), "--threads", "1",
            "--port", "none", "--record", record.toString(), "--until", Double.toString(check.getSeconds() + AFTER)));
        if (python3) {
            arguments.add("--python3");
        }
        String text = new String(Files.readAllBytes(of.script), StandardCharsets.UTF_8);
        PupilProcess process = PupilProcess.run(run, arguments, limit, memory);
        Project world = of.lesson.unpack(own.resolve("world"));
        LessonRun done = new LessonRun(world, run, text, process.getPrinted());
        List<String> missing = new ArrayList<>();
        Mark.Kind kind = howItEnded(process, script, missing);
        if (!Files.isRegularFile(record, LinkOption.NOFOLLOW_LINKS)) {
            missing.add("Your script did not start a simulation: sear.startSimulation()");
            return new Mark(of, kind == null ? Mark.Kind.NOTHING : kind, 0, 0, missing, Map.of());
        }
        kind = check(done, check, record, world, script, missing, kind);
        return new Mark(of, kind, done.getMet(), done.getAsked(), missing, done.getMeasures());
    }

    private static Mark.Kind check(LessonRun done, LessonCheck check, Path record, Project world, String script,
        List<String> missing, Mark.Kind ended) throws ProjectException {
        try {
            done.follow(record, world, check.getSeconds());
        } catch (IOException e) {
            missing.add(ErrorWords.otherWorld(script, done.getScript(), FileReasons.of(e)));
            return ended == null ? Mark.Kind.NOT_YET : ended;
        }
        try {
            check.look(done);
        } catch (IOException e) {
            missing.add(e.getMessage());
            return Mark.Kind.CHECK_FAILED;
        }
        done.getByHand().stream().limit(1)
            .forEach(what -> missing.add("Drive, do not move objects by hand: " + what + "."));
        missing.addAll(done.getMissing());
        return ended != null ? ended : missing.isEmpty() ? Mark.Kind.PASSED : Mark.Kind.NOT_YET;
    }

    private Mark.Kind howItEnded(PupilProcess process, String script, List<String> missing)
        throws InterruptedException {
        if (process.isTooLarge()) {
            missing.add("Your script used more than " + memory + " MB of memory and was stopped.");
            return Mark.Kind.TOO_LARGE;
        } else if (process.getTooLong() != null) {
            missing.add("Your script was stopped: " + process.getTooLong()
                + ". Is there a loop without sear.simSleep?");
            return Mark.Kind.ENDLESS;
        } else if (process.getStatus() != 0) {
            missing.add(error(process.getErrors(), script, process.getStatus()));
            return Mark.Kind.FAILED;
        }
        return null;
    }

    private static String error(String errors, String script, int status) {
        ErrorWords error = new ErrorWords(errors, script);
        return "Your script ended with an error" + (error.line.isEmpty() ? "" : " at line " + error.line) + ": "
            + (error.words.isEmpty() ? "exit status " + status : error.words);
    }

    /** Copies the script, and the modules if it is in the pupil's own folder. */
    private static void copy(Submission of, Path run, String script) throws IOException {
        if (of.script.toAbsolutePath().getParent().getFileName().toString().equals(of.pupil)) {
            try (Stream<Path> files = Files.list(of.script.toAbsolutePath().getParent())) {
                for (Path file : (Iterable<Path>) files.filter(one -> Files.isRegularFile(one) && one.toString()
                    .endsWith(".py"))::iterator) {
                    Files.copy(file, run.resolve(file.getFileName()));
                }
            }
            Files.deleteIfExists(run.resolve(script));
        }
        Files.copy(of.script, run.resolve(script));
    }
}
