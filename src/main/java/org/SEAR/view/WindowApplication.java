// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import com.jme3.app.SimpleApplication;
import com.jme3.app.state.AppState;
import com.jme3.system.AppSettings;
import com.jme3.system.JmeContext;
import com.jme3.system.JmeSystem;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.view.link.WorldLink;
import org.SEAR.view.platform.EngineVersion;
import org.SEAR.view.platform.Glfw;
import org.SEAR.view.platform.LateDisplay;

/**
 * The jMonkeyEngine window. Everything runs on its own thread except {@link #open}, {@link #close} and {@link #isOpen}.
 */
final class WindowApplication extends SimpleApplication {
    private static final Logger LOG = Logger.getLogger(WindowApplication.class.getName());
    /** Referenced so that its level persists. */
    private static final Logger ENGINE = Logger.getLogger("com.jme3");
    private static final int HARDWARE_FRAMES = 60;
    /**
     * Maximum frame rate with software rendering: enough for smooth motion, as each frame takes time from the
     * simulation.
     */
    private static final int SOFTWARE_FRAMES = 34;
    /** Maximum time to open a window, seconds. */
    private static final long TIMEOUT = 60;
    private static final int DEPTH_BITS = 24;

    private final WorldLink link;
    private final WindowOptions options;
    private final Runnable onShown;
    private final ExecutorService background;
    private final CountDownLatch settled = new CountDownLatch(1);
    private volatile Thread thread;
    private volatile String problem;
    private volatile String glfwError;
    private volatile boolean shown;
    private volatile boolean failed;
    private volatile boolean misfit;
    /** Frames drawn since the window opened. */
    volatile long frames;
    private boolean closedByUser;
    private WindowScene scene;
    /** Null if jMonkeyEngine shows its window itself. */
    private LateDisplay display;

    WindowApplication(WorldLink link, WindowOptions options, Runnable onShown) {
        super(new AppState[0]);
        this.link = link;
        this.options = options;
        this.onShown = onShown;
        background = Executors.newSingleThreadExecutor(task -> {
            Thread helper = new Thread(task, "SEAR window helper");
            helper.setDaemon(true);
            return helper;
        });
    }

    /** Opens the window and waits for its first picture, or for the reason why there is none. */
    void open(String renderer) throws InterruptedException {
        AppSettings wanted = new AppSettings(true);
        wanted.setTitle(options.getTitle());
        wanted.setResolution(options.getWidth(), options.getHeight());
        wanted.setResizable(true);
        wanted.setRenderer(renderer);
        wanted.setAudioRenderer(null);
        wanted.setGammaCorrection(false);
        wanted.setVSync(false);
        wanted.setFrameRate(HARDWARE_FRAMES);
        wanted.setDepthBits(DEPTH_BITS);
        wanted.setSamples(options.getSamples());
        setSettings(wanted);
        setShowSettings(false);
        setPauseOnLostFocus(false);
        quieten();
        Glfw.preferX11();
        start();
        if (!settled.await(TIMEOUT, TimeUnit.SECONDS)) {
            problem = "the window did not open within " + TIMEOUT + " s";
            stop();
        }
        if (problem != null) {
            background.shutdownNow();
            if (thread != null && thread != Thread.currentThread()) {
                thread.join(TimeUnit.SECONDS.toMillis(TIMEOUT));
            }
        }
    }

    @Override
    public void start(JmeContext.Type type, boolean wait) {
        try {
            display = new LateDisplay();
        } catch (LinkageError e) {
            LOG.log(Level.FINE, "this jMonkeyEngine shows its window immediately", e);
            super.start(type, wait);
            return;
        }
        JmeSystem.initialize(settings);
        context = display;
        context.setSettings(settings);
        context.setSystemListener(this);
        context.create(wait);
    }

    /** Silences jMonkeyEngine's console messages unless a logging level is set. */
    private static void quieten() {
        if (ENGINE.getLevel() == null) {
            ENGINE.setLevel(Level.SEVERE);
        }
    }

    @Override
    public void initialize() {
        thread = Thread.currentThread();
        guard(super::initialize);
    }

    @Override
    public void simpleInitApp() {
        inputManager.deleteMapping(INPUT_MAPPING_EXIT);
        ModelLoader.prepare(assetManager, link.project().getAssets());
        context.getSettings().setFrameRate(isSoftware() ? SOFTWARE_FRAMES : HARDWARE_FRAMES);
        scene = new WindowScene(this, link, options, background);
    }

    /** Returns whether OpenGL runs in software. Window thread. */
    boolean isSoftware() {
        String card = org.lwjgl.opengl.GL11.glGetString(org.lwjgl.opengl.GL11.GL_RENDERER);
        return card == null || card.contains("llvmpipe") || card.contains("softpipe") || card.contains("SWR")
            || card.contains("GDI Generic");
    }

    @Override
    public void simpleUpdate(float frameTime) {
        scene.update(frameTime);
    }

    @Override
    public void update() {
        if (!failed) {
            guard(this::draw);
        }
    }

    /**
     * Catches exceptions. They would end the window's thread, and older versions of jMonkeyEngine would leave an empty
     * window.
     */
    private void guard(Runnable work) {
        try {
            work.run();
        } catch (LinkageError e) {
            misfit = true;
            fail(EngineVersion.misfit(e), e);
        } catch (RuntimeException e) {
            fail(e.toString(), e);
        }
    }

    private void draw() {
        super.update();
        frames = frames + 1;
        if (!shown && scene.hasPicture()) {
            shown = true;
            if (display != null) {
                display.show();
            }
            onShown.run();
            settled.countDown();
        }
    }

    @Override
    public void reshape(int width, int height) {
        super.reshape(Math.max(1, width), Math.max(1, height));
        if (scene != null) {
            scene.reshape();
        }
    }

    @Override
    public void loseFocus() {
        super.loseFocus();
        if (scene != null) {
            scene.releaseKeys();
        }
    }

    /**
     * Handles errors. jMonkeyEngine reports fatal errors here, which close the window, and GLFW minor ones such as an
     * unsupported window position.
     */
    @Override
    public void handleError(String message, Throwable error) {
        String words = message + (error == null || message.equals(error.getMessage()) ? "" : ": " + error);
        if (!message.startsWith("Uncaught exception") && !message.startsWith("Failed to create display")) {
            glfwError = glfwError == null ? words : glfwError;
            LOG.log(Level.FINE, words, error);
            return;
        }
        thread = Thread.currentThread();
        fail(glfwError == null ? words : glfwError, error);
    }

    /** Closes the window with a reason and stops waiting for its first picture. */
    private void fail(String words, Throwable error) {
        failed = true;
        if (shown) {
            LOG.log(Level.WARNING, words, error);
            options.getWarnings().accept("the simulator window closes: " + words);
        } else {
            problem = words;
            LOG.log(Level.FINE, words, error);
        }
        context.destroy(false);
        settled.countDown();
    }

    @Override
    public void requestClose(boolean escape) {
        closedByUser = true;
        super.requestClose(escape);
    }

    @Override
    public void destroy() {
        super.destroy();
        Glfw.freeLeftovers();
        background.shutdown();
        if (problem == null) {
            link.close(); // another attempt may use the link after a problem
        }
        shown = false;
        if (closedByUser) {
            // no daemon: a process with only this window would end before it sends the message
            new Thread(this::reportClosed, "SEAR window closed").start();
        }
    }

    private void reportClosed() {
        awaitEnd();
        options.getOnClosed().run();
    }

    private void awaitEnd() {
        try {
            thread.join();
            background.awaitTermination(TIMEOUT, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    boolean isOpen() {
        return shown;
    }

    /** Returns whether jMonkeyEngine's classes are incompatible, so that another attempt is useless. */
    boolean isMisfit() {
        return misfit;
    }

    /** Returns why the window never opened, or null. */
    String problem() {
        return problem;
    }

    /** Closes the window and waits for the end of its thread. */
    void close() {
        stop();
        awaitEnd();
    }

    /** Returns the window's content. Window thread. */
    WindowScene scene() {
        return scene;
    }
}
