package org.SEAR.cli;

import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.WebGui;

/** The tabs in the browser. */
final class Tabs {
    private static final String NAME = "webgui";

    private Tabs() {
    }

    /** Serves them on a port of this machine; an error status says why if that can't be. */
    static void start(int port) {
        WebGui webGui = (WebGui) Runtime.create(NAME, "WebGui");
        webGui.setPort(port);
        Runtime.start(NAME);
    }
}
