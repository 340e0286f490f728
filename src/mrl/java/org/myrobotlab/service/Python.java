// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.embedded.Methods;
import org.myrobotlab.embedded.python.ConsoleStream;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.embedded.python.RepeatedErrors;
import org.myrobotlab.embedded.python.ScriptResult;
import org.myrobotlab.embedded.python3.Python3Script;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Platform;
import org.myrobotlab.framework.Registration;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;
import org.myrobotlab.framework.interfaces.MessageListener;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.config.PythonConfig;
import org.myrobotlab.service.data.Script;
import org.myrobotlab.service.interfaces.Processor;
import org.myrobotlab.service.interfaces.ServiceLifeCycleListener;
import org.python.core.PyObject;
import org.slf4j.Logger;

/**
 * Runs Python scripts on the caller's thread. Functions that are listeners run one at a time, in order, on this
 * service's callback thread. Any thread.
 */
public class Python extends Service<PythonConfig> implements ServiceLifeCycleListener, MessageListener, Processor {
    public static final Logger log = LoggerFactory.getLogger(Python.class);

    private static final long serialVersionUID = 1L;
    private static final int SCRIPT_DEPTH = 3;
    /** Imports org first: a folder of that name beside a script would make Jython warn about modules that need org. */
    private static final String IMPORTS = "import org\ndel org\nimport sys\nfrom time import sleep\n";

    /** Scripts open in the editor, by file. The map used here is serialisable, unlike its declared type. */
    @SuppressWarnings("serial")
    Map<String, Script> openedScripts = new ConcurrentHashMap<>();
    protected boolean openOnExecute;
    private transient volatile PythonEngine engine;
    private transient volatile Python3Script python3;
    private final transient RepeatedErrors callbackErrors = new RepeatedErrors();
    private final transient BlockingQueue<Message> callbacks = new LinkedBlockingQueue<>();
    private transient volatile Thread callbackThread;
    /** Whether a script is running; shown by the editor. */
    private volatile boolean executing;
    private final transient AtomicInteger scripts = new AtomicInteger();

    public Python(String name, String id) {
        super(name, id);
    }

    // ---- life cycle
    // ---------------------------------------------------------------------------------------------------

    @Override
    public synchronized void startService() {
        if (isRunning()) {
            return;
        }
        super.startService();
        createPythonInterpreter();
        Runtime.getInstance().attachServiceLifeCycleListener(getName());
        Thread thread = new Thread(this::callBack, "python." + getName() + ".input");
        thread.setDaemon(true);
        callbackThread = thread;
        thread.start();
        config.modulePaths.forEach(this::addModulePath);
        config.startScripts.forEach(this::runConfigured);
    }

    private void runConfigured(String file) {
        try {
            execFile(file);
        } catch (IOException e) {
            error("script %s can't be read: %s", file, e.getMessage());
        }
    }

    /** Creates a new interpreter with only the predefined variables. */
    public synchronized void createPythonInterpreter() {
        if (engine != null) {
            engine.close();
        }
        ConsoleStream out = new ConsoleStream(System.out, text -> invoke("publishStdOut", text));
        ConsoleStream err = new ConsoleStream(System.err, text -> invoke("publishStdError", text));
        PythonEngine fresh = new PythonEngine(getName(), out, err);
        python3 = new Python3Script(out, err);
        fresh.run(IMPORTS);
        fresh.setWarned(this::caution);
        fresh.setFailed(this::failed);
        fresh.set("Platform", Platform.class);
        fresh.set("Runtime", Runtime.class);
        fresh.set("Service", Service.class);
        Runtime.getServices().forEach(service -> introduce(service, fresh));
        engine = fresh; // complete: other threads may run scripts in it from here on
        Runtime.getServices().forEach(service -> introduce(service, fresh)); // services added since the first pass
    }

    /**
     * Returns the interpreter.
     *
     * @throws IllegalStateException while this service starts, and after its release
     */
    private PythonEngine started() {
        PythonEngine current = engine;
        if (current == null) {
            throw new IllegalStateException(Runtime.getService(getName()) == this ? getName()
                + " is starting: try again in a moment"
                : getName() + " has been released: start it again");
        }
        return current;
    }

    /** Publishes a warning; {@code warn(String)} would publish an error. */
    private void caution(String text) {
        Status status = Status.warn("%s", text);
        status.name = getName();
        log.warn("{}: {}", getName(), text);
        broadcastStatus(status);
    }

    /** Reports a thread of the script that has ended with an error. */
    private void failed(String traceback) {
        invoke("publishStdError", traceback + "\n");
        error("%s", traceback);
    }

    /** Defines a class for the service's type and a variable of its name. */
    private static void introduce(ServiceInterface service, PythonEngine engine) {
        engine.set(service.getSimpleName(), service.getClass());
        engine.set(CodecUtils.getSafeReferenceName(service.getName()), service);
    }

    @Override
    public void stopService() {
        stop();
        Thread thread = callbackThread;
        callbackThread = null;
        if (thread != null) {
            thread.interrupt();
        }
        super.stopService();
    }

    @Override
    public void releaseService() {
        if (isRunning()) {
            config.stopScripts.forEach(this::runConfigured);
        }
        tellRepeated();
        super.releaseService();
        PythonEngine old = engine;
        engine = null;
        if (old != null) {
            old.close();
        }
    }

    // ---- running
    // ------------------------------------------------------------------------------------------------------

    /**
     * Runs code and waits for its end.
     *
     * @return whether it succeeded; otherwise an error status has the traceback
     */
    @Override
    public boolean exec(String code) {
        return exec(code, true);
    }

    /**
     * Runs code.
     *
     * @return whether it succeeded; without blocking, whether it was started
     */
    public boolean exec(String code, boolean blocking) {
        PythonEngine current = started();
        if (!blocking) {
            startThread(() -> exec(code));
            return true;
        }
        begun();
        try {
            return report(Python3Script.is(code.getBytes(StandardCharsets.UTF_8)) ? runPython3(code)
                : current.run(code));
        } finally {
            ended();
        }
    }

    private ScriptResult runPython3(String code) {
        try {
            Path folder = Files.createTempDirectory("sear");
            Path file = folder.resolve("script.py");
            try {
                Files.writeString(file, code);
                return started().exited(() -> python3.run(file, List.of()));
            } finally {
                Files.deleteIfExists(file);
                Files.delete(folder);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Runs a file and waits for its end.
     *
     * @return whether it succeeded; otherwise an error status has the traceback
     */
    public boolean execFile(String file) throws IOException {
        return execFile(file, true);
    }

    public boolean execFile(String file, boolean blocking) throws IOException {
        if (!Files.isReadable(Paths.get(file))) {
            failCall("script %s can't be read: there is no such file", file);
            return false;
        }
        PythonEngine current = started();
        if (!blocking) {
            startThread(() -> runConfigured(file));
            return true;
        }
        begun();
        try {
            Path path = Paths.get(file);
            boolean three = Python3Script.is(Files.readAllBytes(path));
            return report(three ? current.exited(() -> python3.run(path, current.getArguments()))
                : current.runFile(file));
        } finally {
            ended();
        }
    }

    private void begun() {
        tellRepeated();
        scripts.incrementAndGet();
        executing = true;
        broadcastState();
    }

    private void ended() {
        executing = scripts.decrementAndGet() > 0;
        invoke("finishedExecutingScript");
        broadcastState();
    }

    public void execAndWait(String code) {
        exec(code, true);
    }

    /** Calls a function of the script. */
    public void execMethod(String method) {
        execMethod(method, new Object[0]);
    }

    public void execMethod(String method, Object... parms) {
        report(started().call(method, parms));
    }

    private void startThread(Runnable work) {
        Thread thread = new Thread(work, getName() + "_script");
        thread.setDaemon(true);
        thread.start();
    }

    private boolean report(ScriptResult result) {
        if (result.isStopped()) {
            info("the script was stopped");
        } else if (result.getTraceback() != null) {
            invoke("publishStdError", result.getTraceback() + "\n");
            error(result.getTraceback());
        }
        return result.getExitCode() == 0 && !result.isStopped();
    }

    private void reportOnce(ScriptResult result) {
        if (result.getTraceback() == null || callbackErrors.isNew(result.getTraceback())) {
            report(result);
        }
    }

    /** Reports how often each repeated error of callbacks occurred; each was shown once. */
    private void tellRepeated() {
        callbackErrors.take().forEach(this::error);
    }

    /**
     * Cancels the script and all callbacks.
     *
     * @return whether anything was running
     */
    public boolean stop() {
        callbacks.clear();
        boolean three = python3 != null && python3.stop();
        return engine != null && engine.interrupt() || three;
    }

    // ---- callbacks
    // ----------------------------------------------------------------------------------------------------

    /** Executes this service's own methods; queues all other messages for functions of the script. */
    @Override
    public boolean preProcessHook(Message msg) {
        Object[] data = msg.data == null ? new Object[0] : msg.data;
        if (Methods.find(getClass(), msg.method, data) != null) {
            return true;
        }
        callbacks.add(msg);
        return false;
    }

    /** Queues a direct call of a script's function with the other callbacks. */
    public void defaultInvokeMethod(String method, Object... params) {
        callbacks.add(Message.createMessage(getName(), getName(), method, params));
    }

    private void callBack() {
        try {
            while (callbackThread == Thread.currentThread()) {
                callBack(callbacks.take());
            }
        } catch (InterruptedException e) {
            log.debug("{}: no more callbacks", getName());
        }
    }

    private void callBack(Message msg) {
        PythonEngine current = engine;
        if (current == null) {
            return;
        }
        if (!current.has(msg.method) && isOptional(msg, current)) {
            return;
        }
        if (!current.has(msg.method)) {
            current.occupied(() -> reportMissing(
                current.missing(CodecUtils.getShortName(msg.sender) + "." + msg.sendingMethod, msg.method)));
            return;
        }
        String publisher = "msg_" + CodecUtils.getSafeReferenceName(msg.sender) + "_" + msg.sendingMethod;
        current.occupied(() -> reportOnce(
            current.callBack(publisher, msg.method, msg.data == null ? new Object[0] : msg.data)));
    }

    private void reportMissing(String missing) {
        if (callbackErrors.isNew(missing)) {
            error("%s", missing);
        }
    }

    /**
     * Returns whether a script may lack the function: addByteListener names four, of which a script needs onByte or
     * onBytes.
     */
    private boolean isOptional(Message msg, PythonEngine current) {
        ServiceInterface sender = Runtime.getService(msg.sender);
        return sender instanceof Serial && ((Serial) sender).isByteListener(getName())
            && ("onConnect".equals(msg.method) || "onDisconnect".equals(msg.method)
                || "onByte".equals(msg.method) && current.has("onBytes") || "onBytes".equals(msg.method)
                    && current.has("onByte"));
    }

    @Override
    public void onMessage(Message msg) {
        in(msg);
    }

    // ---- variables
    // ----------------------------------------------------------------------------------------------------

    public void set(String variable, Object value) {
        started().set(variable, value);
    }

    /** Returns a variable as a Java object; null if there is none. */
    public Object get(String variable) {
        return started().get(variable);
    }

    public PyObject getPyObject(String variable) {
        return started().getPyObject(variable);
    }

    /** Adds a folder to the module path. */
    public void addModulePath(String folder) {
        started().addModulePath(folder);
    }

    // ---- the editor
    // ---------------------------------------------------------------------------------------------------

    /**
     * Opens a script in the editor.
     *
     * @throws IOException if there is no such file
     */
    public void openScript(String file) throws IOException {
        Path path = resolve(file);
        openedScripts.remove(file);
        if (!Files.isRegularFile(path)) {
            throw new IOException("there is no file " + path.toAbsolutePath());
        }
        openedScripts.put(file, new Script(file, Files.readString(path, StandardCharsets.UTF_8)));
        broadcastState();
    }

    public void openScriptFromFile(String file) throws IOException {
        openScript(file);
    }

    /** Updates the editor's text without saving it. */
    public void updateScript(String file, String code) {
        openedScripts.put(file, new Script(file, code));
    }

    public void addScript(String file, String code) throws IOException {
        openedScripts.put(file, new Script(file, code));
        broadcastState();
    }

    public void closeScript(String file) {
        openedScripts.remove(file);
        broadcastState();
    }

    /**
     * Saves a script, completely or not at all.
     *
     * @throws IOException if its folder is missing
     */
    public void saveScript(String file, String code) throws IOException {
        Path path = resolve(file);
        Path part = path.resolveSibling(path.getFileName() + ".part");
        openedScripts.remove(file);
        if (!Files.isDirectory(path.toAbsolutePath().normalize().getParent())) {
            throw new IOException(file + " can't be saved: there is no folder " + path.toAbsolutePath().normalize()
                .getParent() + "; create it first");
        }
        Files.writeString(part, code, StandardCharsets.UTF_8);
        Files.move(part, path, StandardCopyOption.REPLACE_EXISTING);
        openedScripts.put(file, new Script(file, code));
        info("saved %s", path);
    }

    private Path resolve(String file) {
        return config.scriptRootDir == null ? Paths.get(file) : Paths.get(config.scriptRootDir).resolve(file);
    }

    /** Returns the scripts below the script folder, down to three levels. */
    public List<String> getScriptList() throws IOException {
        Path root = resolve("");
        try (Stream<Path> files = Files.walk(root, SCRIPT_DEPTH)) {
            return files.filter(one -> one.toString().endsWith(".py"))
                .map(one -> root.relativize(one).toString()).sorted().collect(Collectors.toList());
        }
    }

    public boolean isOpenOnExecute() {
        return openOnExecute;
    }

    public void setOpenOnExecute(boolean on) {
        openOnExecute = on;
    }

    /** Closes all open scripts. */
    public void clear() {
        openedScripts.clear();
        broadcastState();
    }

    // ---- published methods, and callbacks
    // --------------------------------------------------------------------------------

    /** Publishes each line that a script prints. */
    public String publishStdOut(String data) {
        return data;
    }

    /** Publishes each line of a script's error output, and each traceback. */
    public String publishStdError(String data) {
        return data;
    }

    /** Called when a script has ended. */
    public void finishedExecutingScript() {
        log.debug("{}: script ended", getName());
    }

    @Override
    public void onCreated(String name) {
        log.debug("{} was created", name);
    }

    @Override
    public void onRegistered(Registration registration) {
        log.debug("{} is registered", registration);
    }

    @Override
    public void onStarted(String name) {
        ServiceInterface service = Runtime.getService(name);
        PythonEngine current = engine;
        if (current != null && service != null) {
            introduce(service, current);
        }
    }

    @Override
    public void onStopped(String name) {
        log.debug("{} has stopped", name);
    }

    @Override
    public void onReleased(String name) {
        PythonEngine current = engine;
        if (current != null && Runtime.getService(name) == null) { // another service may have taken the name
            current.remove(CodecUtils.getSafeReferenceName(CodecUtils.getShortName(name)));
        }
    }
}
