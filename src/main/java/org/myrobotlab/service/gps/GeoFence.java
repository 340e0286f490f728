// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

/** An area on the Earth. Immutable, any thread. */
public interface GeoFence {
    /** Returns whether a place is inside. */
    boolean contains(GeoPoint place);
}
