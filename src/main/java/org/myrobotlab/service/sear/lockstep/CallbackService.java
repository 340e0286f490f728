// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

/**
 * A service that runs callbacks on a separate thread, after its messages, and {@link FencePass passes} among them. Any
 * thread.
 */
public interface CallbackService {
    /** Returns the thread of its callbacks; null before the first one. */
    Thread getCallbackThread();
}
