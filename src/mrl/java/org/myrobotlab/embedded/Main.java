// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.util.concurrent.CountDownLatch;
import org.myrobotlab.service.Runtime;

/** Runs the embedded MyRobotLab as a program: starts services and waits for Runtime.shutdown() or Ctrl+C. */
public final class Main {
    private static final String DEFAULT_CONFIG = "default";

    private Main() {
    }

    /** @throws InterruptedException if the thread is interrupted while MyRobotLab runs */
    public static void run(StartOptions options) throws InterruptedException {
        CountDownLatch end = new CountDownLatch(1);
        Shutdown.then(end::countDown);
        java.lang.Runtime.getRuntime().addShutdownHook(new Thread(Runtime::releaseAll, "release"));
        String config = options.getConfig() == null ? DEFAULT_CONFIG : options.getConfig();
        Runtime.setConfig(config);
        Runtime.getInstance();
        if (Configs.read(config, "runtime") != null) {
            Runtime.startConfig(config);
        }
        for (String[] service : options.getServices()) {
            Runtime.start(service[0], service[1]);
        }
        end.await();
    }
}
