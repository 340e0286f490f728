// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.runner.Description;
import org.junit.runner.JUnitCore;
import org.junit.runner.Request;
import org.junit.runner.Result;
import org.junit.runner.Runner;
import org.junit.runner.manipulation.Sorter;
import org.junit.runner.notification.Failure;
import org.junit.runner.notification.RunListener;
import org.junit.runner.notification.RunNotifier;
import org.junit.runners.BlockJUnit4ClassRunner;
import org.junit.runners.model.FrameworkMethod;
import org.junit.runners.model.InitializationError;
import org.junit.runners.model.TestClass;

/**
 * Runs a test class in a separate Java process on its own Xvfb display: {@code @RunWith(UnderXvfb.class)}. Results come
 * back line by line, as if the tests ran here. The process's folder of temporary files is deleted afterwards.
 */
public final class UnderXvfb extends Runner {
    /** Optimizing compiler as users have it, for tests that compare times. */
    private static final List<String> OPTIMIZED = List.of("-XX:TieredStopAtLevel=4");
    private static final String MARK = "##view-test ";
    private final TestClass tests;
    private final Description suite;
    private final Map<String, Description> methods = new HashMap<>();

    public UnderXvfb(Class<?> type) {
        tests = new TestClass(type);
        suite = Description.createSuiteDescription(type);
        List<FrameworkMethod> all = tests.getAnnotatedMethods(Test.class);
        all.stream().sorted(Comparator.comparing(FrameworkMethod::getName)).forEach(method -> {
            Description one = Description.createTestDescription(type, method.getName());
            methods.put(method.getName(), one);
            suite.addChild(one);
        });
    }

    @Override
    public Description getDescription() {
        return suite;
    }

    @Override
    public void run(RunNotifier notifier) {
        StringBuilder log = new StringBuilder();
        Map<String, Description> open = new HashMap<>(methods);
        TemporaryFolder temporary = new TemporaryFolder();
        try (Xvfb server = new Xvfb()) {
            temporary.create();
            List<String> options = new ArrayList<>(List.of("-Xmx192m", "-Djava.io.tmpdir=" + temporary.getRoot()));
            options.addAll(tests.getName().endsWith("ClockTest") ? OPTIMIZED : List.of());
            Process process = Xvfb.java(server.display(), options, Inside.class.getName(), tests.getName()).start();
            BufferedReader lines = new BufferedReader(
                new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (line.startsWith(MARK)) {
                    relay(line.substring(MARK.length()).split(" "), open, notifier);
                } else {
                    log.append(line).append('\n');
                    System.out.println(line);
                }
            }
            log.append("the process ended with ").append(process.waitFor());
        } catch (IOException e) {
            log.append(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            temporary.delete();
        }
        for (Description never : open.values()) {
            notifier.fireTestStarted(never);
            notifier.fireTestFailure(new Failure(never, new AssertionError("did not run to its end:\n" + log)));
            notifier.fireTestFinished(never);
        }
    }

    private void relay(String[] words, Map<String, Description> open, RunNotifier notifier) {
        Description method = methods.get(words[1]);
        switch (words[0]) {
            case "start":
                notifier.fireTestStarted(method);
                break;
            case "fail":
                notifier.fireTestFailure(new Failure(
                    method, new AssertionError(new String(Base64.getDecoder().decode(words[2]),
                    StandardCharsets.UTF_8))));
                break;
            default:
                open.remove(words[1]);
                notifier.fireTestFinished(method);
                break;
        }
    }

    /** The process with the display. */
    public static final class Inside {
        private Inside() {
        }

        /** @param arguments name of the test class */
        public static void main(String[] arguments) throws ClassNotFoundException, InitializationError {
            JUnitCore core = new JUnitCore();
            core.addListener(new RunListener() {
                @Override
                public void testStarted(Description method) {
                    System.out.println(MARK + "start " + method.getMethodName());
                }

                @Override
                public void testFailure(Failure failure) {
                    byte[] trace = failure.getTrace().getBytes(StandardCharsets.UTF_8);
                    System.out.println(MARK + "fail " + failure.getDescription().getMethodName() + " "
                        + Base64.getEncoder().encodeToString(trace));
                }

                @Override
                public void testFinished(Description method) {
                    System.out.println(MARK + "end " + method.getMethodName());
                }
            });
            BlockJUnit4ClassRunner runner = new BlockJUnit4ClassRunner(Class.forName(arguments[0]));
            runner.sort(new Sorter(Comparator.comparing(Description::getMethodName)));
            Result result = core.run(Request.runner(runner));
            System.exit(result.wasSuccessful() ? 0 : 1);
        }
    }
}
