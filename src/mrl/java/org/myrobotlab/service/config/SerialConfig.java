package org.myrobotlab.service.config;

/** Configuration of Serial. */
public class SerialConfig extends ServiceConfig {
    /** The port to open at the start; null for none. */
    public String port;
}
