// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.service.sear.Host;

/**
 * Detects a script that waits in lock-step while simulated time stands still, in a sleep by the computer's clock or in
 * a {@link WaitingLoop loop}. Warns once: the awaited event will not happen. Publisher's thread.
 */
final class ClockTrap {
    /** Number of top stack frames to search for the script's code above a sleep. */
    private static final int DEPTH = 30;
    /** Prefix of the classes that Jython creates from scripts. */
    private static final String SCRIPT = "org.python.pycode.";
    /** End of the name of the service class that scripts call. */
    private static final String SERVICE = ".SEAR";
    /** Calls that advance time, load, draw, or write a file: no script waits in them, so they end a suspected loop. */
    private static final Set<String> NO_LOOP = Set.of("simSleep", "step", "startSimulation", "stopSimulation", "reset",
        "loadProject", "saveProject", "newProject", "importRobot", "importEnvironment", "checkProject", "copyTemplate",
        "rerunRecord", "endRecord", "getRecordValues", "saveRecordCsv", "saveRecordPlot", "savePlot", "savePlan",
        "saveImage");
    private static final String REMEDY =
        ": in lock-step (--speed max, setLockStep(True)) it advances only in sear.simSleep(seconds) and "
        + "sear.step(n), not ";
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final Host host;
    private double lastTime = Double.NaN;
    private boolean suspected;
    private boolean reported;
    private final WaitingLoop loop = new WaitingLoop();

    ClockTrap(Host host) {
        this.host = host;
    }

    /** Checks the script; call repeatedly. */
    void look(SimulationSession session) {
        double time = session.time();
        boolean still = session.isLockStep() && !session.isPaused() && time == lastTime;
        lastTime = time;
        if (reported) {
            return;
        }
        Map<Thread, StackTraceElement[]> stacks = still ? Thread.getAllStackTraces() : Map.of();
        Thread sleeper = stacks.entrySet().stream().filter(entry -> isSleepOfScript(entry.getValue()))
            .map(Map.Entry::getKey).findFirst().orElse(null);
        boolean sleeping = sleeper != null;
        if (sleeping && suspected) {
            reported = true;
            host.warn(ScriptLine.added("the script waits by the computer's clock, but simulated time "
                + "stands still" + REMEDY
                + "in sleep, time.sleep, roomba.sleep, goForward(mm) or spin(degrees)", ScriptLine.of(sleeper)));
        }
        suspected = sleeping;
        lookForLoop(stacks);
    }

    private void lookForLoop(Map<Thread, StackTraceElement[]> stacks) {
        Thread busy = busy(stacks);
        long processor = busy == null ? -1 : THREADS.getThreadCpuTime(busy.getId());
        if (processor < 0) {
            loop.end();
            return;
        }
        String line = line(busy, stacks.get(busy));
        if (loop.look(line, busy.getId(), processor, host.queries())) {
            reported = true;
            host.warn("simulated time has stood still for 2 s while the script is busy at " + line + REMEDY
                + "by itself: call one of them in a loop that waits");
        }
    }

    private static String line(Thread busy, StackTraceElement... stack) {
        String line = ScriptLine.of(busy);
        StackTraceElement script = first(stack, frame -> frame.getClassName().startsWith(SCRIPT));
        return line.isEmpty() ? "line " + script.getLineNumber() + " of " + script.getFileName() : line;
    }

    /**
     * Returns the thread of a busy script: one that neither waits, nor advances time, nor is in a long call. Returns
     * null if there is none, or if any script is in such a call.
     */
    static Thread busy(Map<Thread, StackTraceElement[]> stacks) {
        Thread found = null;
        for (Map.Entry<Thread, StackTraceElement[]> entry : stacks.entrySet()) {
            StackTraceElement script = first(entry.getValue(), frame -> frame.getClassName().startsWith(SCRIPT));
            StackTraceElement call = first(entry.getValue(), frame -> frame.getClassName().endsWith(SERVICE));
            if (script != null && first(entry.getValue(), ClockTrap::isNoLoop) != null) {
                return null;
            }
            if (script != null && (call != null || entry.getKey().getState() == Thread.State.RUNNABLE)) {
                found = entry.getKey();
            }
        }
        return found;
    }

    private static boolean isNoLoop(StackTraceElement frame) {
        return frame.getClassName().endsWith(SERVICE) && NO_LOOP.contains(frame.getMethodName());
    }

    private static StackTraceElement first(StackTraceElement[] stack, Predicate<StackTraceElement> wanted) {
        return Arrays.stream(stack).filter(wanted).findFirst().orElse(null);
    }

    private static boolean isSleepOfScript(StackTraceElement... stack) {
        return stack.length > 0 && Arrays.stream(stack).limit(2)
            .anyMatch(frame -> frame.getClassName().equals(Thread.class.getName())
            && frame.getMethodName().startsWith("sleep")) && Arrays.stream(stack).limit(DEPTH)
            .anyMatch(frame -> frame.getClassName().startsWith(SCRIPT));
    }
}
