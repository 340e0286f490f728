// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.logging;

import org.slf4j.ILoggerFactory;
import org.slf4j.Logger;

/** Creates loggers. */
public class LoggerFactory {
    public static Logger getLogger(Class<?> clazz) {
        return org.slf4j.LoggerFactory.getLogger(clazz);
    }

    public static Logger getLogger(String name) {
        return org.slf4j.LoggerFactory.getLogger(name);
    }

    public static ILoggerFactory getILoggerFactory() {
        return org.slf4j.LoggerFactory.getILoggerFactory();
    }
}
