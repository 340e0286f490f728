// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.life;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;

/** Starts SEAR and a simulation in the class loader of this class and returns the result. */
public class LibraryProbe implements Callable<List<String>> {
    /** Returns the exception and the error statuses. */
    @Override
    public List<String> call() throws InterruptedException {
        List<String> heard = new ArrayList<>();
        Heard listener = (Heard) Runtime.start("probeStatus", "Heard");
        SEAR sear = (SEAR) Runtime.start("probe", "SEAR");
        sear.addListener("publishStatus", "probeStatus", "onStatus");
        try {
            sear.startSimulation();
            sear.simSleep(1);
            sear.getGpsResult("receiver");
            heard.add("runs");
        } catch (IllegalStateException e) {
            heard.add("thrown: " + e.getMessage());
            listener.awaitStatus("error");
        } finally {
            heard.addAll(listener.getStatuses());
            Runtime.releaseAll();
        }
        return heard;
    }
}
