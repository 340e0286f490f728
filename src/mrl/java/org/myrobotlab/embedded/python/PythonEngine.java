// SPDX-License-Identifier: Apache-2.0
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

/** A Python interpreter. Scripts and callbacks share its variables; each runs on its caller's thread. Any thread. */
public final class PythonEngine {
    private static final Logger LOG = LoggerFactory.getLogger(PythonEngine.class);
    /** Prefix of callbacks that services use internally, which are no functions of the script. */
    private static final String OF_SERVICES = "_";
    private static final Map<String, PythonEngine> ENGINES = new ConcurrentHashMap<>();

    private final String name;
    private final PythonInterpreter interpreter;
    private volatile ScriptResult last = ScriptResult.GOOD;
    private volatile List<String> arguments = List.of();
    private volatile Consumer<String> warned = text -> { };
    /** Why the last script or a callback has failed without a result of its own; null if neither has. */
    private volatile String failure;
    private volatile boolean finishing;
    private volatile Consumer<String> failed = text -> { };
    private final ScriptThreads threads = new ScriptThreads(this);
    private final Map<Thread, Run> running = new HashMap<>();
    /** Threads of the script that were started but do not run yet; guarded by {@link #running}. */
    private int starting;
    private volatile boolean closed;
    /** Compiled calls of the script's functions, by function name. */
    private final Map<String, PyCode> calls = new ConcurrentHashMap<>();

    /**
     * @param out output of scripts
     * @param err error output of scripts
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

    /** Returns the interpreter of a running Python service; null if there is none of that name. */
    public static PythonEngine of(String serviceName) {
        return ENGINES.get(serviceName);
    }

    /**
     * Runs a file; its folder is added to the module path.
     *
     * @throws IOException if the file can't be read
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

    public ScriptResult run(String code) {
        return run(code.getBytes(StandardCharsets.UTF_8), "<script>");
    }

    private ScriptResult run(byte[] code, String fileName) {
        SourceText.remember(fileName, code);
        byte[] source = PythonSource.withEncoding(code);
        Py.setSystemState(interpreter.getSystemState());
        ScriptHints.silent(source, fileName).forEach(warned);
        threads.hook(new String(code, StandardCharsets.ISO_8859_1));
        try {
            last = guarded(() -> interpreter.execfile(new ByteArrayInputStream(source), fileName));
        } catch (RuntimeException e) { // Jython can't represent non-ASCII text in its own errors
            LOG.debug("{} could not be run", fileName, e);
            String foreign = ScriptHints.foreign(fileName);
            last = ScriptResult.failed(foreign == null ? fileName + " can't be run: " + e.getMessage() : foreign);
        }
        return last;
    }

    /** Runs a script of another kind, which reports its errors itself. */
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

    /** @param listener gets warnings about likely mistakes before a script runs */
    public void setWarned(Consumer<String> listener) {
        warned = listener;
    }

    /** @param listener gets the errors of the script's threads */
    public void setFailed(Consumer<String> listener) {
        failed = listener;
    }

    /** @param more change in the number of threads that were started but do not run yet */
    void threadStarts(int more) {
        synchronized (running) {
            starting += more;
            running.notifyAll();
        }
    }

    /** Runs the work of a thread of the script, unless the interpreter is closed. */
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
        boolean ends = run.isStopped || finishing
            && e.value.__tojava__(IllegalStateException.class) instanceof IllegalStateException;
        String error = ends ? null : ScriptThreads.failed(e, threadName);
        if (error != null) {
            failure = error;
            failed.accept(error);
        } else if (ends && finishing && !daemon) {
            warned.accept(ScriptThreads.outlived(e, threadName));
        }
    }

    /** Returns the result of the last script. */
    public ScriptResult getLastResult() {
        return last;
    }

    /** Returns the arguments set by {@link #setArguments}. */
    public List<String> getArguments() {
        return arguments;
    }

    /** Sets sys.argv for files, without the file's own name. */
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
        return noted(result);
    }

    /** Returns the error for a callback to a function that the script doesn't have. */
    public String missing(String publisher, String function) {
        Py.setSystemState(interpreter.getSystemState());
        failure = publisher + " calls back " + function + ", but the script has no function of that name"
            + ScriptHints.function(function, interpreter.getLocals());
        return failure;
    }

    private ScriptResult noted(ScriptResult result) {
        failure = result.getTraceback() == null ? failure : result.getTraceback();
        return result;
    }

    /** Marks the scripts and callbacks that run on this thread as failed, for the status at their end. */
    public static void failHere(String reason) {
        for (PythonEngine engine : ENGINES.values()) {
            synchronized (engine.running) {
                engine.failure = engine.running.containsKey(Thread.currentThread()) ? reason : engine.failure;
            }
        }
    }

    /** Returns why a callback or a call without an exception has failed; null if none has. */
    public String getFailure() {
        return failure;
    }

    /**
     * Calls a function as the real MyRobotLab does: the arguments become variables named after their publisher, and the
     * call is compiled once per function name. So a function always gets the values of its first publisher, whichever
     * publisher calls it now.
     *
     * @param publisher prefix of the variable names
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
            // the interpreter's exec would end the line that the script is printing
            Py.setSystemState(interpreter.getSystemState());
            Py.exec(code, interpreter.getLocals(), interpreter.getLocals());
        });
        return noted(result);
    }

    /** Bypasses the interpreter's compile, after which it would reject scripts that declare an encoding. */
    private static PyCode compiled(String code) {
        return Py.compile_flags(code, "<callback>", CompileMode.exec, new CompilerFlags());
    }

    /** Returns whether the script has a variable or function of that name. */
    public boolean has(String variable) {
        return interpreter.get(variable.split("\\.")[0]) != null;
    }

    private ScriptResult guarded(Runnable work) {
        return guarded(null, work);
    }

    /** @param function the function that is called back; null if none is */
    private ScriptResult guarded(String function, Runnable work) {
        Run run = enter();
        try {
            work.run();
            return ScriptResult.GOOD;
        } catch (PyException e) {
            OutOfMemory.report(e);
            return run.isStopped ? ScriptResult.STOPPED
                : run.ended(e, function == null ? null : interpreter.get(function));
        } catch (StackOverflowError e) {
            return ScriptResult.failed("RuntimeError: maximum recursion depth exceeded");
        } finally {
            leave(run);
        }
    }

    /** Runs work that counts as running, with all that it calls here. */
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
     * Lets running callbacks finish and starts no more.
     *
     * @return whether all have ended in time
     */
    public boolean finishCallbacks(long millis) throws InterruptedException {
        finishing = true;
        return await(millis, false);
    }

    /**
     * Lets the script's threads finish.
     *
     * @return whether all have ended in time
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
            || running.entrySet().stream().anyMatch(one -> one.getKey() != Thread.currentThread()
                && one.getValue().isThread == threads);
    }

    /**
     * Cancels everything that runs, with a KeyboardInterrupt.
     *
     * @return whether anything was running
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

    /** Returns whether a script or callback is running. */
    public boolean isRunning() {
        synchronized (running) {
            return !running.isEmpty();
        }
    }

    /** Adds a folder to the module path. */
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

    /** Returns a variable as a Java object; null if there is none. */
    public Object get(String variable) {
        PyObject value = interpreter.get(variable);
        return value == null ? null : value.__tojava__(Object.class);
    }

    /** Returns a variable; null if there is none. */
    public PyObject getPyObject(String variable) {
        return interpreter.get(variable);
    }

    /** Deletes a variable. */
    public void remove(String variable) {
        PyObject variables = interpreter.getLocals();
        if (variables.__finditem__(variable) != null) {
            variables.__delitem__(variable);
        }
    }

    /** Cancels everything that runs and releases the interpreter. */
    public void close() {
        closed = true;
        ENGINES.remove(name, this);
        interrupt();
        interpreter.cleanup();
        interpreter.close();
    }

    /** Execution state of one thread. */
    private static final class Run {
        private final ThreadState state = Py.getThreadState();
        private volatile boolean isStopped;
        /** Whether this is a thread of the script. */
        private volatile boolean isThread;
        /** Whether it has ended with an error that is being formatted. */
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

        /** Raises a KeyboardInterrupt, or in a thread of the script a SystemExit, at the next executed line. */
        void stop() {
            isStopped = true;
            PyFrame frame = state.frame;
            if (frame != null) {
                // Python takes SystemExit for a thread's normal end
                frame.tracefunc = new Breaker(isThread ? Py.SystemExit : Py.KeyboardInterrupt);
            }
        }
    }

    /** Raises an error at the next trace event. */
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
