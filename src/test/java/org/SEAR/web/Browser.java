// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.NoSuchElementException;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.SessionNotCreatedException;
import org.openqa.selenium.StaleElementReferenceException;
import org.openqa.selenium.TimeoutException;
import org.openqa.selenium.WebDriverException;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.WindowType;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.logging.LogEntry;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;
import org.openqa.selenium.support.ui.WebDriverWait;

/**
 * A headless Chromium without display and without data of earlier runs. CSS selectors name elements, and calls wait for
 * them.
 */
public final class Browser implements AutoCloseable {
    /** Timeout of every wait, long enough for slow machines. */
    private static final Duration LIMIT = Duration.ofSeconds(400);
    private static final Duration LOOK = Duration.ofMillis(100);
    private static final int ATTEMPTS = 2;
    /** Browsers as users have them. */
    private static final List<String> WHOLE = List.of("chromium", "chromium-browser", "google-chrome",
        "google-chrome-stable");
    /**
     * The first is Debian's Chromium without windows, which takes less CPU time. The full path avoids a wrapper script
     * on the PATH: the driver would end the script instead of the browser, whose pages would stay connected.
     */
    private static final List<String> BROWSERS = Stream.concat(Stream.of("/usr/lib/chromium/chromium-headless-shell"),
        WHOLE.stream()).collect(Collectors.toList());
    /** For tests that don't look at edges: on the CPU, antialiasing takes as long as the rest of the picture. */
    private static final String ROUGH_EDGES = "--webgl-antialiasing-mode=none";
    private static final List<String> DRIVERS = List.of("chromedriver");

    /**
     * Logger that warns about each Chromium newer than Selenium; a reference keeps its level, which unreferenced
     * loggers lose.
     */
    private static final Logger VERSIONS = Logger.getLogger("org.openqa.selenium.devtools.CdpVersionFinder");

    static {
        VERSIONS.setLevel(Level.SEVERE);
    }

    /** See {@link #shared}; null until it is first used. */
    private static Browser shared;

    private final ChromeDriver driver;
    private final Path downloads;
    private final Elements elements = new Elements(this);
    private final List<String> expected = new ArrayList<>();

    /**
     * @param width of its window, pixels
     * @param height of its window, pixels
     * @param more arguments of the browser
     */
    public Browser(int width, int height, String... more) throws IOException {
        this(BROWSERS, width, height, more);
    }

    private Browser(List<String> programs, int width, int height, String... more) throws IOException {
        String binary = program(programs);
        String driverProgram = program(DRIVERS);
        downloads = Files.createTempDirectory("sear-downloads").toRealPath();
        ChromeOptions options = new ChromeOptions();
        options.setBinary(binary);
        // The profile is the driver's; with another one the first of BROWSERS opens no page.
        options.addArguments("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--hide-scrollbars", "--lang=en",
            "--window-size=" + width + "," + height);
        options.addArguments(more);
        options.setExperimentalOption("prefs",
            Map.of("download.default_directory", downloads.toString(), "download.prompt_for_download", false));
        LoggingPreferences logs = new LoggingPreferences();
        logs.enable(LogType.BROWSER, Level.ALL);
        options.setCapability("goog:loggingPrefs", logs);
        driver = start(driverProgram, options);
        // its driver sets it for the first tab only
        if (!WHOLE.contains(Paths.get(binary).getFileName().toString())) {
            driver.executeCdpCommand("Browser.setDownloadBehavior",
                Map.of("behavior", "allow", "downloadPath", downloads.toString()));
        }
        driver.manage().window().setSize(new Dimension(width, height));
    }

    /** Starts a browser as users have it. */
    public static Browser whole(int width, int height) throws IOException {
        return new Browser(WHOLE, width, height);
    }

    /**
     * Returns the browser that all tests of this process share; it ends with the process. It shows an empty tab in its
     * initial state: no settings, no downloads, no errors. Pages store data by their address, see {@link #forgetPages}.
     * @param width of its window, pixels
     * @param height of its window, pixels
     */
    static synchronized Browser shared(int width, int height) throws IOException {
        if (shared == null || !shared.renew(width, height)) {
            shared = new Browser(width, height, ROUGH_EDGES);
            Runtime.getRuntime().addShutdownHook(new Thread(shared::close));
        }
        return shared;
    }

    /** Deletes the stored data of an address's pages. */
    void forgetPages(String url) {
        driver.executeCdpCommand("Storage.clearDataForOrigin",
            Map.of("origin", url.replaceAll("/$", ""), "storageTypes", "all"));
    }

    /** @return false if the browser has ended or does not answer */
    private boolean renew(int width, int height) throws IOException {
        try {
            Set<String> before = driver.getWindowHandles();
            String empty = driver.switchTo().newWindow(WindowType.TAB).getWindowHandle();
            for (String tab : before) {
                driver.switchTo().window(tab).close();
            }
            driver.switchTo().window(empty);
            driver.manage().window().setSize(new Dimension(width, height));
            forget();
        } catch (WebDriverException e) {
            System.err.println("the browser is started anew: " + e);
            return false;
        }
        MyRobotLab.deleteFolder(downloads());
        Files.createDirectories(downloads());
        return true;
    }

    /** Starts the driver; a busy machine may need a second attempt. */
    private static ChromeDriver start(String driverProgram, ChromeOptions options) {
        for (int attempt = 1;; attempt++) {
            try {
                return new ChromeDriver(new ChromeDriverService.Builder().usingDriverExecutable(new File(driverProgram))
                    .usingAnyFreePort().withSilent(true).build(), options);
            } catch (SessionNotCreatedException e) {
                if (attempt == ATTEMPTS) {
                    throw e;
                }
            }
        }
    }

    private static String program(List<String> names) {
        for (String name : names) {
            for (String folder : System.getenv().getOrDefault("PATH", "").split(File.pathSeparator)) {
                Path file = Paths.get(folder).resolve(name);    // an absolute name stays unchanged
                if (Files.isExecutable(file)) {
                    return file.toString();
                }
            }
        }
        throw new AssertionError("the browser tests need one of " + names + " on the PATH: install Chromium "
            + "and its driver"
            + " (on Debian: apt-get install chromium-headless-shell chromium-driver; ./gradlew check does "
                + "it by itself)");
    }

    /** Returns the driver, for calls without a shorter form here. */
    public ChromeDriver driver() {
        return driver;
    }

    /** Returns the folder of downloads. */
    public Path downloads() {
        return downloads;
    }

    // ---- elements
    // ------------------------------------------------------------------------------------------------------

    /**
     * Waits for a condition.
     * @param what the condition in words, for the message
     */
    public void until(String what, BooleanSupplier condition) {
        value(what, () -> condition.getAsBoolean() ? Boolean.TRUE : null);
    }

    /**
     * Waits for a value.
     * @param supplier returns null as long as there is none
     */
    public <T> T value(String what, Supplier<T> supplier) {
        try {
            return new WebDriverWait(driver, LIMIT, LOOK)
                .ignoring(StaleElementReferenceException.class, NoSuchElementException.class)
                .until(unused -> supplier.get());
        } catch (TimeoutException e) {
            throw new AssertionError("waited " + LIMIT.toSeconds() + " s for " + what, e);
        }
    }

    /** Waits for the first visible element. */
    public WebElement see(String css) {
        return value("a visible " + css, () -> elements.first(css));
    }

    /** Returns all present elements, visible or not. */
    public List<WebElement> all(String css) {
        return driver.findElements(By.cssSelector(css));
    }

    /** Waits until a visible element's text contains a part. */
    public void seeText(String css, String part) {
        value(css + " with the text \"" + part + "\"", () -> elements.withLetters(css, part).stream()
            .map(WebElement::getText).filter(text -> text.contains(part)).findFirst().orElse(null));
    }

    /** Returns the texts of all visible elements. */
    public List<String> texts(String css) {
        return elements.shown(css).stream().map(WebElement::getText).collect(Collectors.toList());
    }

    /** Returns the text of the first visible element. */
    public String text(String css) {
        return see(css).getText();
    }

    /** Clicks an element as soon as it is clickable. */
    public void click(String css) {
        until(css + " that can be clicked", () -> {
            WebElement element = elements.clickable(css);
            if (element == null) {
                return false;
            }
            element.click();
            return true;
        });
    }

    /** Replaces the text of a field by typing. */
    public void type(String css, String text) {
        WebElement field = see(css);
        field.clear();
        field.sendKeys(text);
    }

    /** Chooses an option of a select by its text. */
    public void choose(String css, String option) {
        until("option " + option + " of " + css, () -> {
            WebElement found = elements.option(css, option);
            if (found == null) {
                return false;
            }
            found.click();
            return true;
        });
    }

    /**
     * Runs JavaScript in the page.
     * @return its result: a number (Long or Double), text, Boolean, List, Map or null
     */
    public Object script(String code, Object... arguments) {
        return driver.executeScript(code, arguments);
    }

    /**
     * Runs JavaScript that has a module as {@code module}.
     * @param module its path below {@code js/sear}, such as {@code world/pointing.js}
     */
    public Object module(String module, String code) {
        return script("return import(new URL('service/js/sear/" + module
            + "', document.baseURI)).then(function(module) {" + code + "})");
    }

    /**
     * Evaluates an expression in the scope of a panel, such as {@code scope(".sear-main", "view.toScreen(1, 2).x")}. An
     * unknown name is an error here, whereas Angular returns null.
     */
    public Object scope(String css, String expression) {
        return script("var scope = angular.element(document.querySelector(arguments[0])).scope();"
            + "var name = /[A-Za-z_$][\\w$]*/.exec(arguments[1])[0];"
            + "if (!(name in scope)) { throw new Error('no ' + name + ' in the scope of ' + arguments[0]) }"
            + "return scope.$eval(arguments[1])", css, expression);
    }

    /** Evaluates an expression to a number. */
    public double number(String css, String expression) {
        return ((Number) Objects.requireNonNull(scope(css, expression), expression)).doubleValue();
    }

    /**
     * Sets the preferred colour scheme of the browser's user.
     * @param theme "light" or "dark"
     */
    public void setTheme(String theme) {
        driver.executeCdpCommand("Emulation.setEmulatedMedia",
            Map.of("features", List.of(Map.of("name", "prefers-color-scheme", "value", theme))));
    }

    /**
     * Makes the page narrower than a window can be, as on a telephone; 0 for the window's own width.
     * @param width pixels
     */
    public void setPageWidth(int width) {
        setPageSize(width, 0);
    }

    /**
     * Sets the size of the page independently of the window; 0 for the window's own.
     * @param width pixels
     * @param height pixels
     */
    public void setPageSize(int width, int height) {
        driver.executeCdpCommand("Emulation.setDeviceMetricsOverride",
            Map.of("width", width, "height", height, "deviceScaleFactor", 0, "mobile", false));
    }

    // ---- what went wrong
    // -----------------------------------------------------------------------------------------------

    /**
     * Ignores console errors that this test causes on purpose.
     * @param part of their text
     */
    public void expectErrors(String part) {
        expected.add(part);
    }

    /** Returns new console errors since the last call without the expected ones; includes uncaught exceptions. */
    public List<String> errors() {
        List<String> errors = new ArrayList<>();
        for (LogEntry entry : driver.manage().logs().get(LogType.BROWSER)) {
            if (entry.getLevel().intValue() >= Level.SEVERE.intValue() && expected.stream()
                .noneMatch(entry.getMessage()::contains)) {
                errors.add(entry.getMessage());
            }
        }
        return errors;
    }

    /** Clears errors and expectations for the next test. */
    void forget() {
        driver.manage().logs().get(LogType.BROWSER);
        expected.clear();
    }

    /** Writes a screenshot of the window into a PNG file. */
    public void picture(Path file) throws IOException {
        Files.createDirectories(file.getParent());
        Files.write(file, driver.getScreenshotAs(OutputType.BYTES));
    }

    /** Waits for a finished download. */
    public Path download(String name) {
        Path file = downloads().resolve(name);
        until("the download of " + name, () -> {
            try (Stream<Path> files = Files.list(downloads())) {
                return Files.exists(file) && files.noneMatch(one -> one.toString().endsWith(".crdownload"));
            } catch (IOException e) {
                return false;
            }
        });
        return file;
    }

    @Override
    public void close() {
        try {
            driver.quit();
        } finally {
            MyRobotLab.deleteFolder(downloads);
        }
    }
}
