package org.myrobotlab.service.sear.run;

import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.service.sear.Host;

/**
 * Notices a script that waits while lock-step lets no simulated time pass, by a sleep of the computer's clock or in a loop, and says so once:
 * whatever it waits for will not happen. The publisher's thread.
 */
final class ClockTrap {
    /** Frames from the top in which a sleep stands, between it and the script's code. */
    private static final int DEPTH = 30;
    /** What Jython names the classes that it makes of scripts. */
    private static final String SCRIPT = "org.python.pycode.";
    /** How the class of the service that scripts call is named. */
    private static final String SERVICE = ".SEAR";
    /** Calls that let time pass, and such as may themselves take seconds of the computer's time: none of them is a loop of the script. */
    private static final Set<String> NO_LOOP = Set.of("simSleep", "step", "startSimulation", "stopSimulation", "reset", "loadProject", "saveProject",
        "newProject", "rerunRecord");
    private static final String REMEDY =
        ": in lock-step (--speed max, setLockStep(True)) it passes only in sear.simSleep(seconds) and sear.step(n), not ";
    /** So long a script may be busy while time stands still. */
    private static final long LOOP_NANOS = TimeUnit.SECONDS.toNanos(2);
    /** A loop is found in the same few lines each time; a script that has much to do is not. */
    private static final int LOOP_LINES = 12;
    private static final int LOOP_LOOKS = 10;

    private final Host host;
    private double lastTime = Double.NaN;
    private boolean suspected;
    private boolean reported;
    private long loopSince;
    private int loopLooks;
    private final Set<String> loopLines = new TreeSet<>();

    ClockTrap(Host host) {
        this.host = host;
    }

    /** Called again and again. */
    void look(SimulationSession session) {
        double time = session.time();
        boolean still = session.isLockStep() && !session.isPaused() && time == lastTime;
        lastTime = time;
        if (reported) {
            return;
        }
        Map<Thread, StackTraceElement[]> stacks = still ? Thread.getAllStackTraces() : Map.of();
        Thread sleeper = stacks.entrySet().stream().filter(entry -> isSleepOfScript(entry.getValue())).map(Map.Entry::getKey).findFirst()
            .orElse(null);
        boolean sleeping = sleeper != null;
        if (sleeping && suspected) {
            reported = true;
            host.warn(ScriptLine.added("the script waits by the computer's clock, while simulated time stands still" + REMEDY
                + "in sleep, time.sleep, roomba.sleep, goForward(mm) or spin(degrees)", ScriptLine.of(sleeper)));
        }
        suspected = sleeping;
        lookForLoop(stacks);
    }

    private void lookForLoop(Map<Thread, StackTraceElement[]> stacks) {
        String line = busyLine(stacks);
        if (line != null) {
            loopLines.add(line);
        }
        if (line == null || loopLines.size() > LOOP_LINES || loopLooks == 0) {
            loopLines.clear();
            loopLooks = line == null ? 0 : 1;
            loopSince = System.nanoTime();
            return;
        }
        loopLooks++;
        if (loopLooks > LOOP_LOOKS && System.nanoTime() - loopSince > LOOP_NANOS) {
            reported = true;
            host.warn("simulated time has stood still for 2 s while the script is busy at " + line + REMEDY
                + "by itself: a loop that waits for something needs one of them");
        }
    }

    /** Where a script is that neither waits, nor lets time pass, nor is in a call that takes long; null if there is none, or if another script is. */
    static String busyLine(Map<Thread, StackTraceElement[]> stacks) {
        String found = null;
        for (Map.Entry<Thread, StackTraceElement[]> entry : stacks.entrySet()) {
            StackTraceElement script = first(entry.getValue(), frame -> frame.getClassName().startsWith(SCRIPT));
            StackTraceElement call = first(entry.getValue(), frame -> frame.getClassName().endsWith(SERVICE));
            if (script != null && first(entry.getValue(), ClockTrap::isNoLoop) != null) {
                return null;
            }
            if (script != null && (call != null || entry.getKey().getState() == Thread.State.RUNNABLE)) {
                String line = ScriptLine.of(entry.getKey());
                found = line.isEmpty() ? "line " + script.getLineNumber() + " of " + script.getFileName() : line;
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
        return stack.length > 0 && Arrays.stream(stack).limit(2).anyMatch(frame -> frame.getClassName().equals(Thread.class.getName())
            && frame.getMethodName().startsWith("sleep")) && Arrays.stream(stack).limit(DEPTH).anyMatch(frame -> frame.getClassName()
            .startsWith(SCRIPT));
    }
}
