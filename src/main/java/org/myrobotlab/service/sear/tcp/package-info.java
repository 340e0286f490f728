// SPDX-License-Identifier: Apache-2.0
/**
 * TCP ports that only programs of this computer reach. Uses no other package of SEAR. Any thread.
 */
package org.myrobotlab.service.sear.tcp;
