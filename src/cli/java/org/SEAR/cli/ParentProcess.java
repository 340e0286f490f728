package org.SEAR.cli;

/** The program that started this one and looks after it, as {@code sear class} does: without it this one ends. */
final class ParentProcess {
    private static final String PROPERTY = "sear.parent";

    private ParentProcess() {
    }

    /** Watches it, where there is one. */
    static void watch() {
        Long parent = Long.getLong(PROPERTY);
        if (parent != null) {
            ProcessHandle.of(parent).ifPresentOrElse(one -> one.onExit().thenRun(() -> System.exit(1)), () -> System.exit(1));
        }
    }
}
