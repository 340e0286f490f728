package org.myrobotlab.embedded;

import java.lang.reflect.InvocationTargetException;

/** Says in one line why something failed. */
public final class ErrorReasons {
    private ErrorReasons() {
    }

    /** The message of the innermost cause that has one, with the kind of error where the message alone would not tell. */
    public static String of(Throwable error) {
        Throwable at = error;
        while (at instanceof InvocationTargetException && at.getCause() != null) {
            at = at.getCause();
        }
        if (at instanceof ClassNotFoundException || at instanceof NoClassDefFoundError) {
            return "class " + String.valueOf(at.getMessage()).replace('/', '.') + " is missing: a library is not on the class path";
        }
        if (at instanceof ExceptionInInitializerError && at.getCause() != null) {
            return of(at.getCause());
        }
        String message = at.getMessage();
        String kind = at.getClass().getSimpleName();
        return message == null || message.isEmpty() ? kind : isForPeople(at) ? message : kind + ": " + message;
    }

    /** Whether the message of such an exception is written for people. */
    private static boolean isForPeople(Throwable error) {
        return error instanceof IllegalArgumentException || error instanceof IllegalStateException || error instanceof java.io.IOException;
    }
}
