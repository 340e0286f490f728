// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;

/**
 * A program and all processes that it starts, directly or indirectly. A process whose parent has ended is recognised by
 * a variable of its environment, on Linux; elsewhere only if it was seen before. Any thread.
 */
final class ProcessFamily {
    private static final Path PROC = Path.of("/proc");
    /** Longest time for ending all processes, s. */
    private static final int END_SECONDS = 10;
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    private static final char ZOMBIE = 'Z';
    private static final Path SHELL = Path.of("/bin/sh");
    /** Runs its arguments in a session of their own, where there is a setsid, and stays their parent until they end. */
    private static final String OWN_SESSION =
        "if command -v setsid >/dev/null; then setsid \"$@\"; else \"$@\"; fi; exit $?";

    /** Name of an environment variable that only processes of this family have. */
    private final String mark = "SEAR_FAMILY_" + UUID.randomUUID().toString().replace('-', '_');
    /** Processor time of each process when last seen. */
    private final Map<ProcessHandle, Duration> members = new HashMap<>();

    /**
     * Starts the program. On Linux its parent is a shell and its session is new, so that signals to its parent, process
     * group or terminal reach no other program.
     */
    synchronized Process start(ProcessBuilder builder) throws IOException {
        builder.environment().put(mark, "1");
        if (Files.isExecutable(SHELL)) {
            List<String> command = new ArrayList<>(List.of(SHELL.toString(), "-c", OWN_SESSION, "sear"));
            command.addAll(builder.command());
            builder.command(command);
        }
        Process process = builder.start();
        members.put(process.toHandle(), Duration.ZERO);
        return process;
    }

    /** Searches the computer's processes for new members, and reads the members' processor times. */
    synchronized void look() {
        List<ProcessHandle> others = ProcessHandle.allProcesses().filter(one -> !members.containsKey(one))
            .collect(Collectors.toList());
        others.removeIf(this::addIfMarked);
        boolean grows = true;
        while (grows) {
            grows = others.removeIf(this::addIfChild);
        }
        members.replaceAll(ProcessFamily::computed);
    }

    /** Returns the processor time of a process; the one before if it has ended. */
    private static Duration computed(ProcessHandle one, Duration before) {
        return one.info().totalCpuDuration().filter(now -> now.compareTo(before) > 0).orElse(before);
    }

    private boolean addIfMarked(ProcessHandle one) {
        return read(one, "environ").contains(mark) && members.put(one, Duration.ZERO) == null;
    }

    private boolean addIfChild(ProcessHandle one) {
        return one.parent().filter(members::containsKey).isPresent() && members.put(one, Duration.ZERO) == null;
    }

    /** Returns the processor time of all members, also of ended ones, as of the last look, s. */
    synchronized double seconds() {
        return members.values().stream().mapToLong(Duration::toNanos).sum() / (double) TimeUnit.SECONDS.toNanos(1);
    }

    /** Returns the present memory of all members, kB; 0 if the system doesn't report it. */
    synchronized long kilobytes() {
        return members.keySet().stream().flatMap(one -> read(one, "status").lines())
            .filter(line -> line.startsWith("VmRSS:"))
            .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", ""))).sum();
    }

    /** Kills all members, and those that they start meanwhile. */
    synchronized void end() throws InterruptedException {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(END_SECONDS);
        look();
        for (List<ProcessHandle> left = living(); !left.isEmpty() && System.nanoTime() < deadline; left = living()) {
            left.forEach(ProcessHandle::destroyForcibly);
            await(left, deadline);
            look();
        }
    }

    private List<ProcessHandle> living() {
        return members.keySet().stream().filter(one -> one.isAlive() && !isZombie(one)).collect(Collectors.toList());
    }

    /** Returns whether a process has ended, but its parent has not noticed. */
    private static boolean isZombie(ProcessHandle one) {
        String stat = read(one, "stat");
        int state = stat.lastIndexOf(')') + 2;
        return state < stat.length() && stat.charAt(state) == ZOMBIE;
    }

    private static void await(List<ProcessHandle> some, long deadline) throws InterruptedException {
        List<CompletableFuture<?>> ends = new ArrayList<>();
        some.stream().filter(one -> !isZombie(one)).forEach(one -> ends.add(one.onExit()));
        try {
            long left = Math.max(0, deadline - System.nanoTime());
            CompletableFuture.allOf(ends.toArray(CompletableFuture[]::new)).get(Math.min(LOOK_NANOS, left),
                TimeUnit.NANOSECONDS);
        } catch (ExecutionException e) {
            throw new IllegalStateException(e);
        } catch (TimeoutException e) {
            return;     // zombies count as alive here; the caller looks again
        }
    }

    /** Returns a file of a process in /proc; empty if there is none, or the process belongs to another user. */
    private static String read(ProcessHandle one, String file) {
        Path path = PROC.resolve(Long.toString(one.pid())).resolve(file);
        try {
            return Files.isReadable(path) ? Files.readString(path, StandardCharsets.ISO_8859_1) : "";
        } catch (IOException e) {
            return "";       // the process has just ended
        }
    }
}
