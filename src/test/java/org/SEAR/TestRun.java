// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import org.junit.runner.JUnitCore;
import org.junit.runner.Request;
import org.junit.runner.Result;
import org.junit.runner.notification.Failure;
import org.junit.runner.notification.RunListener;

/**
 * Runs test classes in this JVM with the summary of {@code ./gradlew check}, for Javas that Gradle's own runner does
 * not support.
 */
public final class TestRun {
    private TestRun() {
    }

    /** @param arguments the file for the summary, then the names of the test classes */
    public static void main(String[] arguments) throws IOException {
        JUnitCore core = new JUnitCore();
        core.addListener(new RunListener() {
            @Override
            public void testFailure(Failure failure) {
                System.out.println("\n" + failure.getTestHeader() + " FAILED\n" + failure.getTrimmedTrace());
            }
        });
        Class<?>[] classes = Arrays.stream(arguments).skip(1).map(TestRun::load).toArray(Class<?>[]::new);
        Result result = core.run(Request.classes(classes));
        String summary = summary(result);
        Path file = Paths.get(arguments[0]);
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, summary + "\n");
        System.out.println(summary);
        System.exit(result.wasSuccessful() ? 0 : 1);
    }

    private static Class<?> load(String name) {
        try {
            return Class.forName(name);
        } catch (ClassNotFoundException e) {
            throw new IllegalArgumentException("there is no test class " + name, e);
        }
    }

    static String summary(Result result) {
        int failed = result.getFailureCount();
        int skipped = result.getIgnoreCount() + result.getAssumptionFailureCount();
        return Math.max(0, result.getRunCount() - failed - result.getAssumptionFailureCount()) + " passed, " + failed
            + " failed, " + skipped + " skipped";
    }
}
