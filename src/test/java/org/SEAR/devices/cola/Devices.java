// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.lidar.LidarModel;

/** Scanners in their delivery state, for tests of other packages. */
public final class Devices {
    private Devices() {
    }

    public static ColaScanner scanner(LidarModel model, FakeContext line) {
        FakeScanner scanner = new FakeScanner();
        scanner.world = beam -> 1 + beam / 100.0;
        line.sensor = scanner;
        return new ColaScanner(ColaModel.of(model), model.getSpread(), model.getResolution(), model.getBaud(), line);
    }
}
