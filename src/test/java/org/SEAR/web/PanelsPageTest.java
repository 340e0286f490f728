// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import javax.tools.ToolProvider;
import org.SEAR.documents.DocBlock;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The panel and the calls of docs/panels.md, taken from the page. */
public class PanelsPageTest {
    /** A service for the page's panel: it publishes a number and has a method. */
    private static final String SERVICE = String.join("\n",
        "package org.myrobotlab.service;",
        "public class X extends org.myrobotlab.framework.Service<org.myrobotlab.service.config.ServiceConfig> {",
        "    private static final long serialVersionUID = 1L;",
        "    public X(String name, String id) { super(name, id); }",
        "    public Integer publishNumber(Integer number) { return number; }",
        "    public void doSomething(Integer number) { invoke(\"publishNumber\", number + 4); }",
        "}");
    private static final String LINK = "localhost:8888";
    private static final long PATIENCE_SECONDS = 60;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void theShortestPanelShowsPublishedValuesAndCallsItsService() throws Exception {
        Path classes = folder.newFolder("classes").toPath();
        Path source = folder.newFile("X.java").toPath();
        Files.writeString(source, SERVICE);
        assertEquals(0, ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-proc:none", "-cp", System.getProperty("sear.cliClasspath"), "-d",
            classes.toString(), source.toString()));
        try (MyRobotLab robotLab = new MyRobotLab("Runtime.start('x', 'X')", classes.toString()); Browser browser =
            new Browser(900, 700)) {
            Path panels = robotLab.file("resource/WebGui/app/service");
            Files.writeString(Files.createDirectories(panels.resolve("js")).resolve("XGui.js"),
                only(DocBlock.of("docs/panels.md", "js")));
            Files.writeString(Files.createDirectories(panels.resolve("views")).resolve("XGui.html"),
                only(DocBlock.of("docs/panels.md", "html")));
            browser.driver().get(robotLab.url() + "#/x");
            browser.seeText("mrl-panel[name='x'] p", "x: ");
            browser.click("mrl-panel[name='x'] p button");
            browser.seeText("mrl-panel[name='x'] p", "x: 7 ");
            robotLab.call("x", "doSomething", 8);
            browser.seeText("mrl-panel[name='x'] p", "x: 12 ");
            assertEquals(List.of(), browser.errors());
        }
    }

    @Test
    public void theCallsFromOutsideAreAnswered() throws Exception {
        List<String> calls = DocBlock.commands("docs/panels.md", "curl").stream()
            .filter(line -> !line.contains("Bearer")).collect(Collectors.toList());
        assertEquals(calls.toString(), 3, calls.size());
        try (MyRobotLab robotLab = new MyRobotLab("Runtime.start('sear', 'SEAR')")) {
            assertEquals("true\n", answer(calls.get(0), robotLab));
            assertTrue(robotLab.log(), robotLab.log().lines().anyMatch("1"::equals));
            assertEquals("true\n", answer(calls.get(1), robotLab));
            String services = answer(calls.get(2), robotLab);
            assertTrue(services, services.contains("python@") && services.contains("sear@"));
        }
    }

    @Test
    public void theCallWithTheTokenIsAnsweredAndOneWithoutIsNot() throws Exception {
        String call = only(DocBlock.commands("docs/panels.md", "curl").stream().filter(line -> line.contains("Bearer"))
            .collect(Collectors.toList()));
        try (MyRobotLab robotLab = new MyRobotLab("pass", "", "--token")) {
            assertTrue(answer(call, robotLab).contains("python@"));
            assertTrue(answer(call.replaceAll(" -H .*", " -w '%{http_code}'"), robotLab).endsWith("401"));
        }
    }

    private static String only(List<String> list) {
        assertEquals(list.toString(), 1, list.size());
        return list.get(0);
    }

    /** Returns the output of a line of the page, run for the port of the test. */
    private String answer(String line, MyRobotLab robotLab) throws IOException, InterruptedException {
        assertTrue(line, line.contains(LINK));
        String port = robotLab.url().replaceAll("\\D", "");
        Path output = folder.newFile().toPath();
        ProcessBuilder shell = new ProcessBuilder("sh", "-c", line.replace("8888", port)
            .replaceFirst("^curl ", "curl --silent --show-error "))
            .redirectErrorStream(true).redirectOutput(output.toFile());
        shell.environment().put("HOME", System.getProperty("user.home"));
        Process process = shell.start();
        assertTrue(line, process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertEquals(line + Files.readString(output), 0, process.exitValue());
        return Files.readString(output);
    }
}
