// SPDX-License-Identifier: Apache-2.0
/**
 * Link between a simulation and a window in its own process: messages and their format. Uses {@link org.SEAR.view.link}
 * and its dependencies. One thread reads each pipe; any thread may write.
 */
package org.SEAR.view.process;
