package org.myrobotlab.framework.interfaces;

import java.io.IOException;
import org.myrobotlab.service.config.ServiceConfig;

/** Keeps its configuration in a file. */
public interface StateSaver {
    /** Writes the configuration. */
    boolean save();

    /** Reads the configuration and applies it. */
    ServiceConfig load() throws IOException;
}
