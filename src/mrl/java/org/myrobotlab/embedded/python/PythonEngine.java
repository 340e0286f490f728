package org.myrobotlab.embedded.python;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.myrobotlab.embedded.OutOfMemory;
import org.python.core.CompileMode;
import org.python.core.CompilerFlags;
import org.python.core.Py;
import org.python.core.PyCode;
import org.python.core.PyException;
import org.python.core.PyFrame;
import org.python.core.PyList;
import org.python.core.PyObject;
import org.python.core.PyString;
import org.python.core.ThreadState;
import org.python.core.TraceFunction;
import org.python.util.PythonInterpreter;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One Python interpreter. Scripts and callbacks share its variables; each runs on the thread of whoever calls. Any thread.
 */
public final class PythonEngine {
    private static final Logger LOG = LoggerFactory.getLogger(PythonEngine.class);
    /** So begin the names of what services call back for themselves: no function of the script. */
    private static final String OF_SERVICES = "_";
    private static final Map<String, PythonEngine> ENGINES = new ConcurrentHashMap<>();

    private final String name;
    private final PythonInterpreter interpreter;
    private volatile ScriptResult last = ScriptResult.GOOD;
    private volatile List<String> arguments = List.of();
    private volatile Consumer<String> warned = text -> { };
    private volatile boolean callFailed;
    private volatile boolean finishing;
    private volatile Consumer<String> failed = text -> { };
    private final ScriptThreads threads = new ScriptThreads(this);
    private final Map<Thread, Run> running = new HashMap<>();
    /** Threads of the script that are started and have not begun yet; guarded by {@link #running}. */
    private int starting;
    private volatile boolean closed;
    /** Calls of the script's functions, compiled when they came first, by bare name. */
    private final Map<String, PyCode> calls = new ConcurrentHashMap<>();

    /**
     * @param out where scripts print to
     * @param err where errors go
     */
    public PythonEngine(String name, OutputStream out, OutputStream err) {
        this.name = name;
        JythonStart.await();
        interpreter = new PythonInterpreter(null, JythonStart.newState());
        interpreter.setOut(Py.java2py(new ScriptConsole(out)));
        interpreter.setErr(Py.java2py(new ScriptConsole(err)));
        interpreter.set("__name__", new PyString("__main__"));
        ENGINES.put(name, this);
    }

    /** The interpreter of a running Python service; null if there is none of that name. */
    public static PythonEngine of(String serviceName) {
        return ENGINES.get(serviceName);
    }

    /**
     * Runs a file; its folder is where it imports from.
     *
     * @throws IOException if it can't be read
     */
    public ScriptResult runFile(String file) throws IOException {
        Path path = Paths.get(file).toAbsolutePath();
        byte[] code = Files.readAllBytes(path);
        addModulePath(path.getParent().toString());
        set("__file__", path.toString());
        PyList argv = new PyList();
        argv.append(Py.fileSystemEncode(file));
        arguments.forEach(one -> argv.append(Py.fileSystemEncode(one)));
        interpreter.getSystemState().argv = argv;
        return run(code, file);
    }

    /** Runs code. */
    public ScriptResult run(String code) {
        return run(code.getBytes(StandardCharsets.UTF_8), "<script>");
    }

    private ScriptResult run(byte[] code, String fileName) {
        SourceLine.remember(fileName, code);
        byte[] source = PythonSource.withEncoding(code);
        SilentMistakes.in(source, fileName).forEach(warned);
        threads.hook(new String(code, StandardCharsets.ISO_8859_1));
        try {
            last = guarded(() -> interpreter.execfile(new ByteArrayInputStream(source), fileName));
        } catch (RuntimeException e) { // Jython's own errors, which can't hold what is no ASCII
            LOG.debug("{} could not be run", fileName, e);
            String foreign = SyntaxErrors.foreign(fileName);
            last = ScriptResult.failed(foreign == null ? fileName + " can't be run: " + e.getMessage() : foreign);
        }
        return last;
    }

    /** Runs a script of another kind, which tells its errors itself. */
    public ScriptResult exited(Callable<Integer> script) throws IOException {
        Run run = enter();
        try {
            int status = script.call();
            last = run.isStopped ? ScriptResult.STOPPED : ScriptResult.exited(status);
        } catch (IOException e) {
            throw e;
        } catch (InterruptedException e) {
            last = ScriptResult.STOPPED;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        } finally {
            leave(run);
        }
        return last;
    }

    /** @param listener takes what a script hardly means, before it is run */
    public void setWarned(Consumer<String> listener) {
        warned = listener;
    }

    /** @param listener takes the errors of threads that the script has made */
    public void setFailed(Consumer<String> listener) {
        failed = listener;
    }

    /** @param more by how many threads have been started and not begun yet */
    void threadStarts(int more) {
        synchronized (running) {
            starting += more;
            running.notifyAll();
        }
    }

    /** Does the work of a thread that the script has made; not if it comes to it only after the end. */
    void runThread(PyObject work, String threadName, boolean daemon) {
        Run run;
        synchronized (running) {
            run = enter();
            run.isThread = true;
            threadStarts(-1);
        }
        try {
            if (!closed) {
                work.__call__();
            }
        } catch (PyException e) {
            OutOfMemory.report(e);
            report(e, run, threadName, daemon);
        } finally {
            leave(run);
        }
    }

    private void report(PyException e, Run run, String threadName, boolean daemon) {
        boolean ends = run.isStopped || finishing && e.value.__tojava__(IllegalStateException.class) instanceof IllegalStateException;
        String error = ends ? null : ScriptThreads.failed(e, threadName);
        if (error != null) {
            callFailed = true;
            failed.accept(error);
        } else if (ends && finishing && !daemon) {
            warned.accept(ScriptThreads.outlived(e, threadName));
        }
    }

    /** How the last script ended. */
    public ScriptResult getLastResult() {
        return last;
    }

    /** See {@link #setArguments}. */
    public List<String> getArguments() {
        return arguments;
    }

    /** What files that are run find in sys.argv behind their name. */
    public void setArguments(List<String> newArguments) {
        arguments = List.copyOf(newArguments);
    }

    /** Calls a function of the script. */
    public ScriptResult call(String function, Object... values) {
        ScriptResult result = guarded(() -> {
            PyObject callable = interpreter.eval(function);
            PyObject[] converted = new PyObject[values.length];
            for (int i = 0; i < converted.length; i++) {
                converted[i] = Py.java2py(values[i]);
            }
            callable.__call__(converted);
        });
        callFailed |= result.getTraceback() != null;
        return result;
    }

    /** Something called a function back that the script does not have. */
    public String missing(String publisher, String function) {
        callFailed = true;
        return publisher + " calls back " + function + ", but the script has no function of that name"
            + DidYouMean.function(function, interpreter.getLocals());
    }

    /** Whether a function that was called has raised. */
    public boolean hasCallFailed() {
        return callFailed;
    }

    /**
     * Calls a function as the real MyRobotLab does: the arguments become variables named after their publisher, and the call is compiled once for
     * each function name. So a function always gets the values of the publisher that called it first, whichever script it belongs to now.
     *
     * @param publisher the beginning of the variables' names
     */
    public ScriptResult callBack(String publisher, String function, Object... arguments) {
        if (finishing && !function.startsWith(OF_SERVICES)) {
            return ScriptResult.GOOD;
        }
        ScriptResult result = guarded(function, () -> {
            StringBuilder call = new StringBuilder(function).append('(');
            for (int i = 0; i < arguments.length; i++) {
                String variable = publisher + "_p" + i;
                interpreter.set(variable, arguments[i]);
                call.append(i == 0 ? "" : ",").append(variable);
            }
            PyCode code = calls.computeIfAbsent(function, unused -> compiled(call.append(')').toString()));
            // not by the interpreter's exec, which would end the line that the script is printing
            Py.setSystemState(interpreter.getSystemState());
            Py.exec(code, interpreter.getLocals(), interpreter.getLocals());
        });
        callFailed |= result.getTraceback() != null;
        return result;
    }

    /** Not by the interpreter's own compile: that makes it refuse scripts that name their encoding from then on. */
    private static PyCode compiled(String code) {
        return Py.compile_flags(code, "<callback>", CompileMode.exec, new CompilerFlags());
    }

    /** Whether the script has a function or another variable of that name. */
    public boolean has(String variable) {
        return interpreter.get(variable.split("\\.")[0]) != null;
    }

    private ScriptResult guarded(Runnable work) {
        return guarded(null, work);
    }

    /** @param function that is called back; null if none is */
    private ScriptResult guarded(String function, Runnable work) {
        Run run = enter();
        try {
            work.run();
            return ScriptResult.GOOD;
        } catch (PyException e) {
            OutOfMemory.report(e);
            return run.isStopped ? ScriptResult.STOPPED : run.ended(e, function == null ? null : interpreter.get(function));
        } catch (StackOverflowError e) {
            return ScriptResult.failed("RuntimeError: maximum recursion depth exceeded");
        } finally {
            leave(run);
        }
    }

    /** Does work that counts as running until its end, with all that it calls here. */
    public void occupied(Runnable work) {
        Run run = enter();
        try {
            work.run();
        } finally {
            leave(run);
        }
    }

    private Run enter() {
        synchronized (running) {
            Run run = running.computeIfAbsent(Thread.currentThread(), thread -> new Run());
            run.depth++;
            return run;
        }
    }

    private void leave(Run run) {
        synchronized (running) {
            run.depth--;
            if (run.depth > 0) {
                return;
            }
            running.remove(Thread.currentThread());
            running.notifyAll();
            if (run.isStopped) {
                Thread.interrupted();
            }
        }
    }

    /**
     * Lets the callbacks that run now come to their end, and no more begin.
     *
     * @return whether they have ended within that time
     */
    public boolean finishCallbacks(long millis) throws InterruptedException {
        finishing = true;
        return await(millis, false);
    }

    /**
     * Lets the threads that the script has made come to their end.
     *
     * @return whether they have ended within that time
     */
    public boolean finishThreads(long millis) throws InterruptedException {
        return await(millis, true);
    }

    private boolean await(long millis, boolean ofThreads) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
        synchronized (running) {
            long left = millis;
            while (othersRun(ofThreads) && left > 0) {
                running.wait(left);
                left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            }
            return !othersRun(ofThreads);
        }
    }

    private boolean othersRun(boolean threads) {
        return threads && starting > 0
            || running.entrySet().stream().anyMatch(one -> one.getKey() != Thread.currentThread() && one.getValue().isThread == threads);
    }

    /**
     * Breaks off all that runs, with a KeyboardInterrupt.
     *
     * @return whether anything ran
     */
    public boolean interrupt() {
        synchronized (running) {
            running.forEach((thread, run) -> {
                if (thread != Thread.currentThread() && !run.hasRaised) {
                    run.stop();
                    thread.interrupt();
                }
            });
            return !running.isEmpty();
        }
    }

    /** Whether a script or callback runs now. */
    public boolean isRunning() {
        synchronized (running) {
            return !running.isEmpty();
        }
    }

    /** Adds a folder that modules are imported from. */
    public void addModulePath(String folder) {
        PyList path = interpreter.getSystemState().path;
        PyString entry = Py.fileSystemEncode(folder);
        if (!path.contains(entry)) {
            path.insert(0, entry);
        }
    }

    public void set(String variable, Object value) {
        interpreter.set(variable, value);
    }

    /** A variable as a Java object; null if there is none. */
    public Object get(String variable) {
        PyObject value = interpreter.get(variable);
        return value == null ? null : value.__tojava__(Object.class);
    }

    /** A variable; null if there is none. */
    public PyObject getPyObject(String variable) {
        return interpreter.get(variable);
    }

    /** Forgets a variable. */
    public void remove(String variable) {
        PyObject variables = interpreter.getLocals();
        if (variables.__finditem__(variable) != null) {
            variables.__delitem__(variable);
        }
    }

    /** Breaks off all that runs and forgets everything. */
    public void close() {
        closed = true;
        ENGINES.remove(name, this);
        interrupt();
        interpreter.cleanup();
        interpreter.close();
    }

    /** What runs on one thread. */
    private static final class Run {
        private final ThreadState state = Py.getThreadState();
        private volatile boolean isStopped;
        /** Of a thread that the script has made. */
        private volatile boolean isThread;
        /** It has come to its end by an error, which is being put into words. */
        private volatile boolean hasRaised;
        private int depth;

        ScriptResult ended(PyException e, PyObject calledBack) {
            hasRaised = true;
            try {
                return ScriptResult.of(e, calledBack);
            } finally {
                hasRaised = false;
            }
        }

        /** Raises a KeyboardInterrupt, in a thread a SystemExit, at the next line that is carried out. */
        void stop() {
            isStopped = true;
            PyFrame frame = state.frame;
            if (frame != null) {
                frame.tracefunc = new Breaker(isThread ? Py.SystemExit : Py.KeyboardInterrupt); // which Python takes for the end of a thread
            }
        }
    }

    /** Raises an error, whatever happens next. */
    private static final class Breaker extends TraceFunction {
        private final PyObject error;

        Breaker(PyObject error) {
            this.error = error;
        }

        @Override
        public TraceFunction traceCall(PyFrame frame) {
            throw new PyException(error);
        }

        @Override
        public TraceFunction traceReturn(PyFrame frame, PyObject value) {
            throw new PyException(error);
        }

        @Override
        public TraceFunction traceLine(PyFrame frame, int line) {
            throw new PyException(error);
        }

        @Override
        public TraceFunction traceException(PyFrame frame, PyException e) {
            return null;
        }
    }
}
