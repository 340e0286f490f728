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

/** A headless Chromium without display and without memory of earlier runs. Elements are named by CSS selectors and waited for. */
public final class Browser implements AutoCloseable {
    /** For everything that takes time: slow machines get all they need. */
    private static final Duration LIMIT = Duration.ofSeconds(400);
    private static final Duration LOOK = Duration.ofMillis(100);
    private static final int ATTEMPTS = 2;
    /** As users have them. */
    private static final List<String> WHOLE = List.of("chromium", "chromium-browser", "google-chrome", "google-chrome-stable");
    /**
     * The first is Debian's Chromium without the windows that nobody sees here, which takes less processor time. By its full name: on the PATH is a
     * script that waits for it, which is what its driver would end then, and not the browser, whose pages would stay connected.
     */
    private static final List<String> BROWSERS = Stream.concat(Stream.of("/usr/lib/chromium/chromium-headless-shell"), WHOLE.stream())
        .collect(Collectors.toList());
    /** For tests that look at no edges: by the processor, smooth ones take as long as the whole picture without. */
    private static final String ROUGH_EDGES = "--webgl-antialiasing-mode=none";
    private static final List<String> DRIVERS = List.of("chromedriver");

    /** Warns of each Chromium that is newer than Selenium; held here, since loggers that nobody holds forget their level. */
    private static final Logger VERSIONS = Logger.getLogger("org.openqa.selenium.devtools.CdpVersionFinder");

    static {
        VERSIONS.setLevel(Level.SEVERE);
    }

    /** See {@link #shared}; null until it is asked for. */
    private static Browser shared;

    private final ChromeDriver driver;
    private final Path downloads;
    private final Elements elements = new Elements(this);
    private final List<String> expected = new ArrayList<>();

    /**
     * @param width of its window in pixels
     * @param height of its window in pixels
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
        // and with a profile of its driver's: told of another, the first of BROWSERS opens no page
        options.addArguments("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
            "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--hide-scrollbars", "--lang=en",
            "--window-size=" + width + "," + height);
        options.addArguments(more);
        options.setExperimentalOption("prefs", Map.of("download.default_directory", downloads.toString(), "download.prompt_for_download", false));
        LoggingPreferences logs = new LoggingPreferences();
        logs.enable(LogType.BROWSER, Level.ALL);
        options.setCapability("goog:loggingPrefs", logs);
        driver = start(driverProgram, options);
        if (!WHOLE.contains(Paths.get(binary).getFileName().toString())) {      // its driver tells it for the first tab only
            driver.executeCdpCommand("Browser.setDownloadBehavior", Map.of("behavior", "allow", "downloadPath", downloads.toString()));
        }
        driver.manage().window().setSize(new Dimension(width, height));
    }

    /** One as users have it. */
    public static Browser whole(int width, int height) throws IOException {
        return new Browser(WHOLE, width, height);
    }

    /**
     * The one for all who share it in this process, with which it ends. It shows an empty tab, new as its user: nothing set, nothing downloaded, no
     * errors. What pages keep, they keep by their address: see {@link #forgetPages}.
     *
     * @param width of its window in pixels
     * @param height of its window in pixels
     */
    static synchronized Browser shared(int width, int height) throws IOException {
        if (shared == null || !shared.renew(width, height)) {
            shared = new Browser(width, height, ROUGH_EDGES);
            Runtime.getRuntime().addShutdownHook(new Thread(shared::close));
        }
        return shared;
    }

    /** Forgets what pages of an address have kept. */
    void forgetPages(String url) {
        driver.executeCdpCommand("Storage.clearDataForOrigin", Map.of("origin", url.replaceAll("/$", ""), "storageTypes", "all"));
    }

    /** @return false if it has ended or does not answer */
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

    /** A machine that is busy with other things may need a second attempt. */
    private static ChromeDriver start(String driverProgram, ChromeOptions options) {
        for (int attempt = 1;; attempt++) {
            try {
                return new ChromeDriver(new ChromeDriverService.Builder().usingDriverExecutable(new File(driverProgram)).usingAnyFreePort()
                    .withSilent(true).build(), options);
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
                Path file = Paths.get(folder).resolve(name);    // a full name is itself
                if (Files.isExecutable(file)) {
                    return file.toString();
                }
            }
        }
        throw new AssertionError("the browser tests need one of " + names + " on the PATH: install Chromium and its driver"
            + " (on Debian: apt-get install chromium-headless-shell chromium-driver; ./gradlew test does it by itself)");
    }

    /** For what has no shorter way here. */
    public ChromeDriver driver() {
        return driver;
    }

    /** Where downloads go. */
    public Path downloads() {
        return downloads;
    }

    // ---- elements ------------------------------------------------------------------------------------------------------

    /**
     * Waits for a condition.
     *
     * @param what is waited for, for the message
     */
    public void until(String what, BooleanSupplier condition) {
        value(what, () -> condition.getAsBoolean() ? Boolean.TRUE : null);
    }

    /**
     * Waits until something is there.
     *
     * @param supplier answers null as long as it is not
     */
    public <T> T value(String what, Supplier<T> supplier) {
        try {
            return new WebDriverWait(driver, LIMIT, LOOK).ignoring(StaleElementReferenceException.class, NoSuchElementException.class)
                .until(unused -> supplier.get());
        } catch (TimeoutException e) {
            throw new AssertionError("waited " + LIMIT.toSeconds() + " s for " + what, e);
        }
    }

    /** The first visible element. */
    public WebElement see(String css) {
        return value("a visible " + css, () -> elements.first(css));
    }

    /** All elements that are there now, visible or not. */
    public List<WebElement> all(String css) {
        return driver.findElements(By.cssSelector(css));
    }

    /** Waits until there is a visible element whose text has such a part. */
    public void seeText(String css, String part) {
        value(css + " with the text \"" + part + "\"", () -> elements.withLetters(css, part).stream().map(WebElement::getText)
            .filter(text -> text.contains(part)).findFirst().orElse(null));
    }

    /** Texts of all visible elements. */
    public List<String> texts(String css) {
        return elements.shown(css).stream().map(WebElement::getText).collect(Collectors.toList());
    }

    /** Text of the first visible element. */
    public String text(String css) {
        return see(css).getText();
    }

    /** Clicks an element as soon as that can be clicked. */
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

    /** Types into a field in place of what is in it. */
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
     *
     * @return what it returns: a number (Long or Double), text, Boolean, List, Map or null
     */
    public Object script(String code, Object... arguments) {
        return driver.executeScript(code, arguments);
    }

    /**
     * What JavaScript returns that has a module as {@code module}.
     *
     * @param module its path below {@code js/sear}, as {@code world/pointing.js}
     */
    public Object module(String module, String code) {
        return script("return import(new URL('service/js/sear/" + module + "', document.baseURI)).then(function(module) {"
            + code + "})");
    }

    /**
     * Evaluates an expression in the scope of a panel, as {@code scope(".sear-main", "view.toScreen(1, 2).x")}. Angular takes a name that is not
     * there for null; here it is an error.
     */
    public Object scope(String css, String expression) {
        return script("var scope = angular.element(document.querySelector(arguments[0])).scope();"
            + "var name = /[A-Za-z_$][\\w$]*/.exec(arguments[1])[0];"
            + "if (!(name in scope)) { throw new Error('no ' + name + ' in the scope of ' + arguments[0]) }"
            + "return scope.$eval(arguments[1])", css, expression);
    }

    /** The same as a number. */
    public double number(String css, String expression) {
        return ((Number) Objects.requireNonNull(scope(css, expression), expression)).doubleValue();
    }

    /**
     * Whether pages are to be light or dark, as the browser's user has set it.
     *
     * @param theme "light" or "dark"
     */
    public void setTheme(String theme) {
        driver.executeCdpCommand("Emulation.setEmulatedMedia", Map.of("features", List.of(Map.of("name", "prefers-color-scheme", "value", theme))));
    }

    /**
     * Makes the page narrower than a window can be, as a telephone's; 0 for the window's own width.
     *
     * @param width pixels
     */
    public void setPageWidth(int width) {
        setPageSize(width, 0);
    }

    /**
     * Gives the page a size without regard to the window; 0 for the window's own.
     *
     * @param width pixels
     * @param height pixels
     */
    public void setPageSize(int width, int height) {
        driver.executeCdpCommand("Emulation.setDeviceMetricsOverride",
            Map.of("width", width, "height", height, "deviceScaleFactor", 0, "mobile", false));
    }

    // ---- what went wrong -----------------------------------------------------------------------------------------------

    /**
     * Errors of the console that this test brings about on purpose.
     *
     * @param part of their text
     */
    public void expectErrors(String part) {
        expected.add(part);
    }

    /** Errors of the console since the last time this was asked, without the expected ones; uncaught exceptions too. */
    public List<String> errors() {
        List<String> errors = new ArrayList<>();
        for (LogEntry entry : driver.manage().logs().get(LogType.BROWSER)) {
            if (entry.getLevel().intValue() >= Level.SEVERE.intValue() && expected.stream().noneMatch(entry.getMessage()::contains)) {
                errors.add(entry.getMessage());
            }
        }
        return errors;
    }

    /** Forgets errors and expectations, for the next test. */
    void forget() {
        driver.manage().logs().get(LogType.BROWSER);
        expected.clear();
    }

    /** Writes what the window shows into a PNG file. */
    public void picture(Path file) throws IOException {
        Files.createDirectories(file.getParent());
        Files.write(file, driver.getScreenshotAs(OutputType.BYTES));
    }

    /** A finished download; waits for it. */
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
