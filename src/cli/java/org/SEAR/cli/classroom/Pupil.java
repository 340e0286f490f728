// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.classroom;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;

/** A pupil's folder, port, link and program. Guarded by its {@link Classroom}. */
final class Pupil {
    /** State of the program. */
    enum State { WAITING, STARTING, RUNNING, GIVEN_UP }

    /** Limit of automatic restarts in a row. */
    static final int MAX_RESTARTS = 5;
    /** Running time after which the restart count is reset, ns. */
    private static final long WELL_NANOS = TimeUnit.MINUTES.toNanos(10);
    private static final long START_NANOS = TimeUnit.MINUTES.toNanos(3);
    private static final int CONNECT_MILLIS = 200;
    private static final int OUT_OF_MEMORY = 3;
    private static final int BY_SIGNAL = 128;
    private static final int KILLED = 137;

    final String name;
    final Path folder;
    final int port;
    final String link;
    private final List<String> command;
    private final InetSocketAddress address;
    private final Path log;
    private final Set<ProcessHandle> started = ConcurrentHashMap.newKeySet();

    private State state = State.WAITING;
    private Process process;
    private OutputLog output;
    private int restarts;
    private long since;
    private long megabytes;
    private String end;

    Pupil(String name, Path folder, int port, String link, List<String> command, InetSocketAddress address, Path log) {
        this.name = name;
        this.folder = folder;
        this.port = port;
        this.link = link;
        this.command = command;
        this.address = address;
        this.log = log;
        this.since = System.nanoTime();
    }

    State state() {
        return state;
    }

    /** Returns the memory of the program and its child processes when last measured, MB. */
    long megabytes() {
        return megabytes;
    }

    /** Returns whether the program may start now; the delay doubles with each restart. */
    boolean isDue() {
        return state == State.WAITING && System.nanoTime()
            - since >= (restarts == 0 ? 0 : TimeUnit.SECONDS.toNanos(1L << restarts - 1));
    }

    /**
     * Starts the program.
     *
     * @throws IOException if the port is not free, or the program can't be started
     */
    void start() throws IOException {
        since = System.nanoTime();
        try (ServerSocket probe = new ServerSocket()) {
            probe.bind(address);
        } catch (IOException e) {
            throw new IOException("port " + port + " is not free: " + e.getMessage(), e);
        }
        end = null;
        process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
        process.getOutputStream().close();
        output = OutputLog.keep(process.getInputStream(), log);
        state = State.STARTING;
    }

    /** Counts a failed start. */
    void failed() {
        restarts++;
        since = System.nanoTime();
        state = restarts > MAX_RESTARTS ? State.GIVEN_UP : State.WAITING;
    }

    /** Returns a message if the program has ended; else empty. */
    Optional<String> look() {
        if (process == null) {
            return Optional.empty();
        }
        long age = System.nanoTime() - since;
        if (!process.isAlive()) {
            return Optional.of(ended());
        }
        if (state == State.STARTING && answers()) {
            state = State.RUNNING;
        } else if (state == State.STARTING && age > START_NANOS) {
            stop("it did not start in " + TimeUnit.NANOSECONDS.toMinutes(START_NANOS) + " minutes");
        } else if (state == State.RUNNING && age > WELL_NANOS) {
            restarts = 0;
        }
        return Optional.empty();
    }

    private boolean answers() {
        try (Socket socket = new Socket()) {
            InetSocketAddress own = address.getAddress().isAnyLocalAddress()
                ? new InetSocketAddress("localhost", port) : address;
            socket.connect(own, CONNECT_MILLIS);
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    private String ended() {
        String why = why(process.exitValue());
        endStarted();
        process = null;
        megabytes = 0;
        restarts++;
        since = System.nanoTime();
        state = restarts > MAX_RESTARTS ? State.GIVEN_UP : State.WAITING;
        return why + (state == State.GIVEN_UP ? "; not restarted after " + MAX_RESTARTS + " times: type the name and "
            + "Enter to restart it" : "; restarting (" + restarts + " of " + MAX_RESTARTS + ")");
    }

    private String why(int status) {
        if (end != null) {
            return end;
        }
        if (status == OUT_OF_MEMORY && output.isOutOfMemory()) {
            return "out of memory";
        }
        if (status == KILLED) {
            return "killed, by a user or because the computer is short of memory";
        }
        return status > BY_SIGNAL ? "ended by signal " + (status - BY_SIGNAL) : "ended with status " + status;
    }

    /** Measures the memory of the program and its child processes, and ends all if they exceed the limit. */
    void weigh(ProcessTable table, long most) {
        if (process == null || !process.isAlive()) {
            return;
        }
        megabytes = table.megabytes(process.pid());
        started.removeIf(one -> !one.isAlive());
        for (long one : table.tree(process.pid())) {
            if (one != process.pid()) {
                ProcessHandle.of(one).ifPresent(started::add);
            }
        }
        if (megabytes > most) {
            stop("used " + megabytes + " MB with all that it has started, more than " + most);
        }
    }

    private void stop(String why) {
        end = why;
        process.destroyForcibly();
        endStarted();
    }

    /** Ends processes that the program has left behind. */
    private void endStarted() {
        started.forEach(ProcessHandle::destroyForcibly);
        started.clear();
    }

    /** Ends the program for a restart; also restarts one that was given up. */
    void renew() {
        if (process != null) {
            stop("ended by the teacher");
        }
        restarts = 0;
        state = process == null ? State.WAITING : state;
    }

    /** Asks the program to end. */
    void askToEnd() {
        if (process != null) {
            process.descendants().forEach(started::add);
            process.destroy();
        }
    }

    /** Waits for the program's end, and kills it after the deadline. */
    void end(long deadline) throws InterruptedException {
        if (process != null && !process.waitFor(Math.max(0, deadline - System.nanoTime()), TimeUnit.NANOSECONDS)) {
            process.destroyForcibly().waitFor();
        }
        endStarted();
    }
}
