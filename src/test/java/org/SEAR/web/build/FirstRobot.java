// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiConsumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.FreePort;
import org.SEAR.SearProcess;
import org.SEAR.web.Browser;
import org.SEAR.web.SearTab;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/**
 * Follows docs/first-robot.md: its commands, its script and its clicks, given as comments after the sentences that
 * describe them.
 * <pre>
 * &lt;!-- click CSS --> &lt;!-- until EXPRESSION --> &lt;!-- set FIELD VALUE --> &lt;!-- choose CSS OPTION -->
 * &lt;!-- ground X Z --> &lt;!-- restart --> &lt;!-- picture NAME -->
 * </pre>
 */
public final class FirstRobot implements AutoCloseable {
    private static final Pattern STEP =
        Pattern.compile("<!-- (\\w+)(?: ((?:(?!-->).)*?))? -->|^`{3}(\\w+)\\n(.*?)^`{3}",
        Pattern.DOTALL | Pattern.MULTILINE);
    private static final Pattern ADDRESS = Pattern.compile("http://localhost:\\d+/");
    private static final long PATIENCE_SECONDS = 240;
    private static final long LOOK_MILLIS = 100;

    /** Pairs of a command's output on the page and its actual output. */
    public final List<String[]> printed = new ArrayList<>();
    /** Number of commands, scripts and outputs of the page that were run or compared. */
    public int blocks;
    private final Browser browser;
    private final Path folder;
    private final BiConsumer<Browser, String> taken;
    private Process sear;
    private int port;
    private String output = "";

    /**
     * @param folder an empty folder
     * @param taken receives the name of each picture when the page shows its subject
     */
    public FirstRobot(Browser browser, Path folder, BiConsumer<Browser, String> taken) {
        this.browser = browser;
        this.folder = folder;
        this.taken = taken;
    }

    /** @return number of steps of the page */
    public int walk() throws IOException, InterruptedException {
        String page = Files.readString(Paths.get(System.getProperty("sear.root", "."), "docs/first-robot.md"));
        Matcher step = STEP.matcher(page);
        int steps = 0;
        for (; step.find(); steps++) {
            if (step.group(3) == null) {
                act(step.group(1), step.group(2) == null ? "" : step.group(2));
            } else {
                run(step.group(3), step.group(4));
            }
        }
        return steps;
    }

    private void run(String language, String text) throws IOException, InterruptedException {
        blocks++;
        if (language.equals("python")) {
            Files.writeString(folder.resolve("first.py"), text);
        } else if (language.equals("text")) {
            printed.add(new String[] {text.replace("8888", String.valueOf(port)), output});
        } else if (text.trim().equals("sear")) {
            begin();
        } else {
            end();
            List<String> command = SearProcess.command();
            command.addAll(List.of(text.trim().split(" ")).subList(1, text.trim().split(" ").length));
            command.addAll(List.of("--port", "none"));
            Process process = start(command);
            if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
                throw new AssertionError(text + " did not end: " + Files.readString(log()));
            }
            output = Files.readString(log());
        }
    }

    /** Starts sear and opens its page in the browser. */
    private void begin() throws IOException {
        port = FreePort.find();
        List<String> command = SearProcess.command();
        command.addAll(List.of("--headless", "--port", String.valueOf(port)));
        sear = start(command);
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        Matcher address = ADDRESS.matcher("");
        while (!address.find()) {
            if (!sear.isAlive() || System.nanoTime() > end) {
                throw new AssertionError("no page: " + Files.readString(log()));
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(LOOK_MILLIS));
            output = Files.readString(log());
            address.reset(output);
        }
        browser.driver().get(address.group());
        browser.see(SearTab.ROOT);
        await("world.preview !== null && edits.grammar !== null");
    }

    private void end() {
        browser.driver().get("about:blank");
        close();
    }

    /** Ends the {@code sear} of the page. */
    @Override
    public void close() {
        if (sear != null) {
            sear.destroy();
            sear.onExit().join();
        }
        sear = null;
    }

    private Process start(List<String> command) throws IOException {
        return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(log().toFile()).start();
    }

    private Path log() {
        return folder.resolve("output.txt");
    }

    private void await(String expression) {
        browser.until(expression, () -> Boolean.TRUE.equals(browser.scope(SearTab.ROOT, expression)));
    }

    private void act(String step, String rest) throws IOException {
        String[] words = rest.split(" ");
        if (step.equals("click")) {
            browser.click(rest);
        } else if (step.equals("until")) {
            await(rest);
        } else if (step.equals("set")) {
            WebElement field = browser.see("[data-field='" + words[0] + "'] .form-control");
            field.sendKeys(Keys.chord(Keys.CONTROL, "a"));
            field.sendKeys(words[1], Keys.ENTER);
            await("edits.object && edits.object.values." + words[0] + " == '" + words[1] + "'");
        } else if (step.equals("choose")) {
            browser.choose(words[0], words[1]);
        } else if (step.equals("ground")) {
            clickGround(Double.parseDouble(words[0]), Double.parseDouble(words[1]));
        } else if (step.equals("restart")) {
            begin();
        } else if (step.equals("picture")) {
            taken.accept(browser, rest);
        } else {
            throw new AssertionError("docs/first-robot.md has a step of no kind: " + step + " " + rest);
        }
    }

    /** Clicks the ground in the current view, in space or on the map. */
    private void clickGround(double x, double z) {
        boolean space = Boolean.TRUE.equals(browser.scope(SearTab.ROOT, "view.mode == 'space'"));
        String at = space ? "view.scene().toScreen(" + x + ", 0, " + z + ")" : "view.toScreen(" + x + ", " + z + ")";
        WebElement view = browser.see(space ? ".sear-scene" : ".sear-view");
        Dimension size = view.getSize();
        new Actions(browser.driver()).moveToElement(view, (int) Math.round(browser.number(SearTab.ROOT, at + ".x"))
            - size.getWidth() / 2,
            (int) Math.round(browser.number(SearTab.ROOT, at + ".y")) - size.getHeight() / 2).click().perform();
    }
}
