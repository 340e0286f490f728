// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.util.function.Consumer;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Status;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;

/**
 * Explains errors of scripts in a real MyRobotLab, whose Python service publishes them as text. The embedded one
 * explains them itself. Any thread; hints come from a thread of their own.
 */
public final class ScriptErrors {
    /** SEAR's method for errors of Python services. */
    private static final String CALLBACK = "onScriptError";
    private static final String EMBEDDED = "org.myrobotlab.embedded.python.ServiceTypes";
    private static final String HINTS = "sear_hints";
    private static final char LAST_ASCII = '~';

    private ScriptErrors() {
    }

    /** Listens to the errors of all Python services, in a real MyRobotLab. */
    public static void listen(String listener) {
        if (Members.find(EMBEDDED) == null) {
            Runtime.getServices().stream().filter(one -> one instanceof Python)
                .forEach(python -> python.addListener("publishError", listener, CALLBACK));
        }
    }

    /**
     * Explains an error.
     *
     * @param listener gets the hint, if there is one
     * @return whether the message is such an error
     */
    public static boolean takes(Message message, Consumer<String> listener) {
        if (!CALLBACK.equals(message.method) || message.data == null || !(message.data[0] instanceof Status)) {
            return false;
        }
        Status status = (Status) message.data[0];
        ServiceInterface python = Runtime.getService(message.getSrcName());
        String text = String.valueOf(status.detail == null ? status.key : status.detail);
        if (python instanceof Python && text.contains("Error: ") && !text.contains(HINTS)) {
            Thread thread = new Thread(() -> explain((Python) python, text, listener), "script error");
            thread.setDaemon(true);
            thread.start();
        }
        return true;
    }

    private static void explain(Python python, String text, Consumer<String> listener) {
        Object hint = python.invoke("evalAndWait", "__import__('" + HINTS + ".jython').jython.printed(" + literal(text)
            + ", globals())");
        if (hint instanceof String && !((String) hint).isEmpty()) {
            python.invoke("publishStdOut", hint + "\n");
            listener.accept((String) hint);
        }
    }

    /** Returns a text as a literal of Python 2. */
    private static String literal(String text) {
        StringBuilder literal = new StringBuilder("u'");
        text.chars().forEach(c -> {
            if (c < ' ' || c > LAST_ASCII || c == '\'' || c == '\\') {
                literal.append(String.format("\\u%04x", c));
            } else {
                literal.append((char) c);
            }
        });
        return literal.append('\'').toString();
    }
}
