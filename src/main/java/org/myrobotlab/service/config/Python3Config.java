// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

/** Saved configuration of a Python 3 service: empty. */
public class Python3Config extends ServiceConfig {
}
