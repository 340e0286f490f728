package org.SEAR.view;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.SEAR.view.platform.DisplayCheck;

/** How a {@link SimulatorWindow} is to look and behave. Filled by one thread before the window opens, and not changed afterwards. */
public final class WindowOptions {
    /** Default width in pixels. */
    public static final int WIDTH = 1024;
    /** Default height in pixels. */
    public static final int HEIGHT = 640;
    private static final int SMALLEST = 160;
    private static final int LARGEST = 8192;
    private static final int MAX_SAMPLES = 16;

    private String title = "SEAR";
    private int width = WIDTH;
    private int height = HEIGHT;
    private int samples;
    private boolean debugShapes;
    private boolean ownProcess = DisplayCheck.needsFirstThread();
    private Path screenshotFolder = Paths.get("screenshots");
    private BooleanSupplier scriptDrives = () -> false;
    private Runnable onClosed = () -> { };
    private Consumer<String> warnings = message -> { };

    /** The title bar's text; default "SEAR". */
    public WindowOptions setTitle(String text) {
        title = Objects.requireNonNull(text);
        return this;
    }

    /** @param newWidth pixels, default 1024, likewise height, default 640; [160, 8192] */
    public WindowOptions setSize(int newWidth, int newHeight) {
        width = checked("width", newWidth);
        height = checked("height", newHeight);
        return this;
    }

    private static int checked(String what, int value) {
        if (value < SMALLEST || value > LARGEST) {
            throw new IllegalArgumentException("window " + what + " is " + value + ", legal: " + SMALLEST + " to " + LARGEST + " pixels");
        }
        return value;
    }

    /** Smooths edges by so many samples a pixel: 0 (none) to 16, default 0, because a machine without a graphics card pays for each. */
    public WindowOptions setSamples(int count) {
        if (count < 0 || count > MAX_SAMPLES) {
            throw new IllegalArgumentException("window samples is " + count + ", legal: 0 to " + MAX_SAMPLES);
        }
        samples = count;
        return this;
    }

    /** Whether collision shapes, contact points and wheel rays show from the start; F3 changes it. Default false. */
    public WindowOptions setDebugShapes(boolean on) {
        debugShapes = on;
        return this;
    }

    /**
     * Whether the window runs in a process of its own, which the window's user does not notice: needed on macOS, and its default there; elsewhere it
     * keeps a graphics driver that crashes away from this process, at the price of another Java process. Default elsewhere: false.
     */
    public WindowOptions setOwnProcess(boolean on) {
        ownProcess = on || DisplayCheck.needsFirstThread();
        return this;
    }

    /** Where F12 puts its pictures; made when needed. Default {@code screenshots} below the working folder. */
    public WindowOptions setScreenshotFolder(Path folder) {
        screenshotFolder = Objects.requireNonNull(folder);
        return this;
    }

    /** Answers whether a script drives the robot now, so that the keys must not; asked on the window's thread. Default: never. */
    public WindowOptions setScriptDrives(BooleanSupplier question) {
        scriptDrives = Objects.requireNonNull(question);
        return this;
    }

    /** Runs once, on a thread of the window, after the user has closed it; not after {@link SimulatorWindow#close()}. Default: nothing. */
    public WindowOptions setOnClosed(Runnable action) {
        onClosed = Objects.requireNonNull(action);
        return this;
    }

    /** Takes what the user should know about the window itself (no display, picture not written); any thread. Default: nothing. */
    public WindowOptions setWarnings(Consumer<String> receiver) {
        warnings = Objects.requireNonNull(receiver);
        return this;
    }

    public String getTitle() {
        return title;
    }

    public int getWidth() {
        return width;
    }

    public int getHeight() {
        return height;
    }

    public int getSamples() {
        return samples;
    }

    public boolean isDebugShapes() {
        return debugShapes;
    }

    public boolean isOwnProcess() {
        return ownProcess;
    }

    public Path getScreenshotFolder() {
        return screenshotFolder;
    }

    public BooleanSupplier getScriptDrives() {
        return scriptDrives;
    }

    public Runnable getOnClosed() {
        return onClosed;
    }

    public Consumer<String> getWarnings() {
        return warnings;
    }
}
