// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

/** Configuration of Serial. */
public class SerialConfig extends ServiceConfig {
    /** Last opened port; null for none. */
    public String port;
}
