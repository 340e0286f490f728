// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.problems;

import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;

/** Messages for Java's file exceptions, many of which only contain the path. Any thread. */
public final class FileReasons {
    private FileReasons() {
    }

    /** Returns the reason, with the file if it is known: {@code /x/robot.sear: permission denied}. */
    public static String of(Exception e) {
        if (e instanceof FileSystemException && ((FileSystemException) e).getReason() == null) {
            return ((FileSystemException) e).getFile() + ": " + kind((FileSystemException) e);
        }
        String message = e.getMessage() == null ? e.toString() : e.getMessage();
        return message.contains("No space left") ? message + " (the disk is full: free some space "
            + "and try again)" : message;
    }

    private static String kind(FileSystemException e) {
        if (e instanceof AccessDeniedException) {
            return "permission denied (another owner, a read-only place, or a file that another program holds open)";
        }
        if (e instanceof NoSuchFileException) {
            return "there is no such file or folder";
        }
        if (e instanceof FileAlreadyExistsException) {
            return "it exists already";
        }
        return e instanceof DirectoryNotEmptyException ? "the folder is not empty" : e.getClass().getSimpleName();
    }
}
