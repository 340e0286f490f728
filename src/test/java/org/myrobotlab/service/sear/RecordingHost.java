// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/** A host that stores the messages it receives. */
public final class RecordingHost implements Host {
    public final List<String> warnings = new CopyOnWriteArrayList<>();
    public final List<String> errors = new CopyOnWriteArrayList<>();
    public final List<SensorReading> readings = new CopyOnWriteArrayList<>();

    @Override
    public String getName() {
        return "test";
    }

    @Override
    public String getResourceRoot() {
        return "resource";
    }

    @Override
    public void progress(String message) {
        warnings.add(message);
    }

    @Override
    public void warn(String message) {
        warnings.add(message);
    }

    @Override
    public void error(String message) {
        errors.add(message);
    }

    @Override
    public void windowClosed() {
        warnings.add("window closed");
    }

    @Override
    public void reading(SensorReading reading) {
        readings.add(reading);
    }

    @Override
    public void state() {
        // no listeners
    }
}
