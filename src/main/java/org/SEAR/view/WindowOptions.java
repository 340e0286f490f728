// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Look and behaviour of a {@link SimulatorWindow}. One thread fills it before the window opens; it is not changed
 * afterwards.
 */
public final class WindowOptions {
    /** Default width, pixels. */
    public static final int WIDTH = 1024;
    /** Default height, pixels. */
    public static final int HEIGHT = 640;
    private static final int SMALLEST = 160;
    private static final int LARGEST = 8192;
    private static final int MAX_SAMPLES = 16;

    private String title = "SEAR";
    private int width = WIDTH;
    private int height = HEIGHT;
    private int samples;
    private boolean debugShapes;
    private Path screenshotFolder = Paths.get("screenshots");
    private BooleanSupplier scriptDrives = () -> false;
    private Runnable onClosed = () -> { };
    private Consumer<String> warnings = message -> { };

    /** Sets the title bar's text; default "SEAR". */
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
            throw new IllegalArgumentException("window " + what + " is " + value + ", legal: " + SMALLEST + " to "
                + LARGEST + " pixels");
        }
        return value;
    }

    /**
     * Sets the samples per pixel for smooth edges of a window in this process: 0 (none) to 16, default 0. Each one
     * costs time without a graphics card.
     */
    WindowOptions setSamples(int count) {
        if (count < 0 || count > MAX_SAMPLES) {
            throw new IllegalArgumentException("window samples is " + count + ", legal: 0 to " + MAX_SAMPLES);
        }
        samples = count;
        return this;
    }

    /**
     * Sets whether collision shapes, contact points and wheel rays are visible from the start; F3 toggles them. Default
     * false.
     */
    public WindowOptions setDebugShapes(boolean on) {
        debugShapes = on;
        return this;
    }

    /**
     * Sets the folder for F12's pictures; created when needed. Default {@code screenshots} below the working folder.
     */
    public WindowOptions setScreenshotFolder(Path folder) {
        screenshotFolder = Objects.requireNonNull(folder);
        return this;
    }

    /**
     * Sets the check whether a script drives the robot, which disables the keys; called on the window's thread.
     * Default: never.
     */
    public WindowOptions setScriptDrives(BooleanSupplier question) {
        scriptDrives = Objects.requireNonNull(question);
        return this;
    }

    /**
     * Sets an action that runs once, on a thread of the window, after the user has closed it; not after
     * {@link SimulatorWindow#close()}. Default: nothing.
     */
    public WindowOptions setOnClosed(Runnable action) {
        onClosed = Objects.requireNonNull(action);
        return this;
    }

    /**
     * Sets the receiver of warnings about the window (no display, picture not saved), called on any thread. Default:
     * none.
     */
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

    int getSamples() {
        return samples;
    }

    public boolean isDebugShapes() {
        return debugShapes;
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
