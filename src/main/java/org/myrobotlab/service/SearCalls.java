// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.util.concurrent.Callable;
import java.util.concurrent.atomic.LongAdder;
import org.SEAR.grammar.ScriptLine;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.ProjectException;
import org.myrobotlab.framework.Status;

/**
 * Runs the calls of a SEAR service. Errors are published as an error status and thrown: IllegalArgumentException for
 * values, otherwise IllegalStateException. Any thread.
 */
final class SearCalls {
    private final SEAR service;
    private final LongAdder count = new LongAdder();

    SearCalls(SEAR service) {
        this.service = service;
    }

    /** A call without a result. */
    interface Action {
        void run() throws Exception;
    }

    void act(Action action) {
        attempt(() -> {
            action.run();
            return null;
        });
    }

    /** Returns the number of calls so far. */
    long count() {
        return count.sum();
    }

    <T> T attempt(Callable<T> work) {
        count.increment();
        try {
            if (!service.isWhole()) {
                throw new IllegalStateException(service.getName() + " is not started: Runtime.start(\""
                    + service.getName() + "\", \"SEAR\")");
            }
            return work.call();
        } catch (IllegalArgumentException e) {
            publish(FileReasons.of(e));
            throw e;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the script was stopped while it waited", e);
        } catch (LinkageError e) {
            publish(missing(e));
            throw new IllegalStateException(missing(e), e);
        } catch (Exception e) {
            if (e instanceof ProjectException) {
                service.invoke("publishProblems", ((ProjectException) e).getProblems());
            }
            publish(FileReasons.of(e));
            throw e instanceof IllegalStateException ? (IllegalStateException) e
                : new IllegalStateException(FileReasons.of(e), e);
        }
    }

    /** A calling script sees the exception, so the log needs no second line. */
    private void publish(String error) {
        if (!ScriptLine.isCalling()) {
            service.error("%s", error);
            return;
        }
        Status status = Status.error("%s", error);
        status.name = service.getName();
        service.broadcastStatus(status);
    }

    static String missing(LinkageError e) {
        return "SEAR can't run here, a library is missing or broken (" + e + "): run \"sear install\" for this "
            + "MyRobotLab again, or put the jars that come with SEAR into libraries/jar";
    }
}
