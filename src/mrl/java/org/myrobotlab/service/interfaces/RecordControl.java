// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import java.io.FileNotFoundException;

/** Records its bytes to files. */
public interface RecordControl {
    /** Starts recording. */
    void record() throws FileNotFoundException;

    /** Stops recording. */
    void stopRecording();

    /** Whether it is recording. */
    boolean isRecording();
}
