package org.myrobotlab.service.interfaces;

import java.io.FileNotFoundException;

/** Records what it does. */
public interface RecordControl {
    /** Starts. */
    void record() throws FileNotFoundException;

    /** Ends. */
    void stopRecording();

    /** Whether it does. */
    boolean isRecording();
}
