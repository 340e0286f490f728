// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

/** The program that started and supervises this one, such as {@code sear class}; this program ends with it. */
final class ParentProcess {
    private static final String PROPERTY = "sear.parent";

    private ParentProcess() {
    }

    /** Watches the parent process, if there is one. */
    static void watch() {
        Long parent = Long.getLong(PROPERTY);
        if (parent != null) {
            ProcessHandle.of(parent).ifPresentOrElse(one -> one.onExit().thenRun(() -> System.exit(1)),
                () -> System.exit(1));
        }
    }
}
