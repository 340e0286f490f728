// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Status;

/** Reports errors, warnings and notices. */
public interface LoggingSink extends NameProvider {
    /** Publishes an error. */
    Status error(Exception e);

    /** Publishes an error. */
    Status error(String format, Object... args);

    /** Publishes a warning. */
    Status warn(String format, Object... args);

    /** Publishes a notice. */
    Status info(String format, Object... args);
}
