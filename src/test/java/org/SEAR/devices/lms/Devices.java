// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Variant;

/** An LMS200 in its delivery state, for tests of other packages. */
public final class Devices {
    private Devices() {
    }

    public static Lms200 lms200(FakeContext line) {
        FakeScanner scanner = new FakeScanner();
        scanner.world = beam -> 1 + beam / 100.0;
        line.sensor = scanner;
        return new Lms200(new PowerOnSettings(Variant.V180_HALF, 9600, false, Identity.LMS200_30106), line);
    }
}
