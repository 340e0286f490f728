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
import org.SEAR.view.platform.NativeMemory;
import org.SEAR.view.platform.X11Guard;

/** The window itself. Its own thread runs everything but {@link #open}, {@link #close} and {@link #isOpen}. */
final class WindowApplication extends SimpleApplication implements WindowHandle {
    private static final Logger LOG = Logger.getLogger(WindowApplication.class.getName());
    /** Held, so that its level stays. */
    private static final Logger ENGINE = Logger.getLogger("com.jme3");
    private static final int HARDWARE_FRAMES = 60;
    /** A little more than anybody needs to see motion: each picture takes caches and time from the simulation. */
    private static final int SOFTWARE_FRAMES = 34;
    /** Seconds that a machine may take to open a window. */
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
    /** Pictures drawn since the window opened. */
    volatile long frames;
    private volatile boolean closing;
    private boolean closedByUser;
    private WindowScene scene;
    /** Null where jMonkeyEngine shows its window itself. */
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
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        Thread.currentThread().setContextClassLoader(WindowApplication.class.getClassLoader());
        try {
            Glfw.preferX11();
            start();
        } finally {
            Thread.currentThread().setContextClassLoader(before);
        }
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
            LOG.log(Level.FINE, "another jMonkeyEngine shows its window at once", e);
            super.start(type, wait);
            return;
        }
        JmeSystem.initialize(settings);
        context = display;
        context.setSettings(settings);
        context.setSystemListener(this);
        context.create(wait);
    }

    /** jMonkeyEngine tells the console about every graphics card and every missing sound loader, unless somebody wants to hear it. */
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
        X11Guard.install(this::displayLost);
        inputManager.deleteMapping(INPUT_MAPPING_EXIT);
        ModelLoader.prepare(assetManager, link.project().getAssets());
        context.getSettings().setFrameRate(isSoftware() ? SOFTWARE_FRAMES : HARDWARE_FRAMES);
        scene = new WindowScene(this, link, options, background);
    }

    /** Whether OpenGL is worked out by the processor. Window thread. */
    boolean isSoftware() {
        String card = org.lwjgl.opengl.GL11.glGetString(org.lwjgl.opengl.GL11.GL_RENDERER);
        return card == null || card.contains("llvmpipe") || card.contains("softpipe") || card.contains("SWR") || card.contains("GDI Generic");
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

    /** What leaves this class's methods would end the window's thread, and older versions of jMonkeyEngine then leave an empty window behind. */
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
     * jMonkeyEngine calls this for what it can't go on with, and GLFW for everything down to a window position that the desktop doesn't like: only
     * the former ends the window.
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

    /** Takes the window away and says why; the first picture is no longer waited for. */
    private void fail(String words, Throwable error) {
        failed = true;
        if (shown) {
            LOG.log(Level.WARNING, words, error);
            options.getWarnings().accept("the simulator window has to close: " + words);
        } else {
            problem = words;
            LOG.log(Level.FINE, words, error);
        }
        context.destroy(false);
        settled.countDown();
    }

    /** The X server went away. What is left of the window is not touched again: any call could end the process. */
    private void displayLost() {
        if (!closing) {
            options.getWarnings().accept("the display of the simulator window is lost; the simulation goes on without it");
        }
        context.destroy(false);
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
            link.close(); // otherwise another window may be tried on it
        }
        shown = false;
        if (closedByUser && !closing) {
            // no daemon: a process that has only this window would end before the message is out
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
            NativeMemory.giveBack();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public boolean isOpen() {
        return shown && !closing;
    }

    /** Whether classes of jMonkeyEngine are not those that the window was made for, so that another attempt is vain. */
    boolean isMisfit() {
        return misfit;
    }

    @Override
    public String problem() {
        return problem;
    }

    @Override
    public void close() {
        if (problem != null || thread == null) {
            return;
        }
        closing = true;
        stop();
        if (Thread.currentThread() != thread) {
            awaitEnd();
        }
    }

    /** What is on the window. Window thread. */
    WindowScene scene() {
        return scene;
    }
}
