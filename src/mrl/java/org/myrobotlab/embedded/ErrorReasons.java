// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.lang.reflect.InvocationTargetException;

/** Describes the cause of an error in one line. */
public final class ErrorReasons {
    private ErrorReasons() {
    }

    /**
     * Returns the message of the error, with its class name unless the message is written for users.
     * Unwraps {@code InvocationTargetException} and {@code ExceptionInInitializerError}.
     */
    public static String of(Throwable error) {
        Throwable at = error;
        while (at instanceof InvocationTargetException && at.getCause() != null) {
            at = at.getCause();
        }
        if (at instanceof ClassNotFoundException || at instanceof NoClassDefFoundError) {
            return "class " + String.valueOf(at.getMessage()).replace('/', '.') + " is missing: a library is not on "
                + "the class path";
        }
        if (at instanceof ExceptionInInitializerError && at.getCause() != null) {
            return of(at.getCause());
        }
        String message = at.getMessage();
        String kind = at.getClass().getSimpleName();
        return message == null || message.isEmpty() ? kind : isForPeople(at) ? message : kind + ": " + message;
    }

    /** Returns whether messages of this exception type are written for users. */
    private static boolean isForPeople(Throwable error) {
        return error instanceof IllegalArgumentException || error instanceof IllegalStateException
            || error instanceof java.io.IOException;
    }
}
