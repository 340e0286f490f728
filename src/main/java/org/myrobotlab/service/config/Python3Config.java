package org.myrobotlab.service.config;

/** A Python 3 service remembers nothing. */
public class Python3Config extends ServiceConfig {
}
