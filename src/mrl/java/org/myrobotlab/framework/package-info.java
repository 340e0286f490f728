// SPDX-License-Identifier: Apache-2.0
/**
 * MyRobotLab's framework: the service, its messages, subscriptions and configuration. Names and signatures are those of
 * the real MyRobotLab, see docs/embedded-and-real.md. Any thread unless a class says otherwise.
 */
package org.myrobotlab.framework;
