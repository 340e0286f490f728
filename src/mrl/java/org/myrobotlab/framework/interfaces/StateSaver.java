// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import java.io.IOException;
import org.myrobotlab.service.config.ServiceConfig;

/** Saves its configuration in a file. */
public interface StateSaver {
    /** Saves the configuration. */
    boolean save();

    /** Reads the configuration and applies it. */
    ServiceConfig load() throws IOException;
}
