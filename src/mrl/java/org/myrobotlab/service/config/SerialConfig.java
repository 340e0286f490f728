package org.myrobotlab.service.config;

/** Configuration of Serial. */
public class SerialConfig extends ServiceConfig {
    /** The port that was opened last; null for none. */
    public String port;
}
