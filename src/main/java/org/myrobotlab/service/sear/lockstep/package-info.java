// SPDX-License-Identifier: Apache-2.0
/**
 * Waits until bytes and messages have been processed, so that in lock-step a script's callbacks have run before time
 * advances. Uses {@link org.myrobotlab.serial} and {@link org.myrobotlab.service.sear}, and what these use. Knows the
 * queues and ports of MyRobotLab, both the embedded and the real one. Thread that advances time.
 */
package org.myrobotlab.service.sear.lockstep;
