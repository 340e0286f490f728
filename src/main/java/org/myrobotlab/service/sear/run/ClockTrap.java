package org.myrobotlab.service.sear.run;

import java.util.Arrays;
import org.myrobotlab.service.sear.Host;

/**
 * Notices a script that waits by the computer's clock while lock-step lets no simulated time pass, and says so once: whatever it waits for will not
 * happen. The publisher's thread.
 */
final class ClockTrap {
    /** Frames from the top in which a sleep stands, between it and the script's code. */
    private static final int DEPTH = 30;
    /** What Jython names the classes that it makes of scripts. */
    private static final String SCRIPT = "org.python.pycode.";

    private final Host host;
    private double lastTime = Double.NaN;
    private boolean suspected;
    private boolean told;

    ClockTrap(Host host) {
        this.host = host;
    }

    /** Called again and again. */
    void look(SimulationSession session) {
        double time = session.time();
        boolean still = session.isLockStep() && !session.isPaused() && time == lastTime;
        lastTime = time;
        if (told) {
            return;
        }
        boolean sleeping = still && Thread.getAllStackTraces().values().stream().anyMatch(ClockTrap::isSleepOfScript);
        if (sleeping && suspected) {
            told = true;
            host.warn("the script waits by the computer's clock, while simulated time stands still: in lock-step (--speed max, setLockStep(True)) it"
                + " passes only in sear.simSleep(seconds) and sear.step(n), not in sleep, time.sleep, roomba.sleep, goForward(mm) or spin(degrees)");
        }
        suspected = sleeping;
    }

    private static boolean isSleepOfScript(StackTraceElement... stack) {
        return stack.length > 0 && Arrays.stream(stack).limit(2).anyMatch(frame -> frame.getClassName().equals(Thread.class.getName())
            && frame.getMethodName().startsWith("sleep")) && Arrays.stream(stack).limit(DEPTH).anyMatch(frame -> frame.getClassName()
            .startsWith(SCRIPT));
    }
}
