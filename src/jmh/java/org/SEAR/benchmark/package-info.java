// SPDX-License-Identifier: Apache-2.0
/**
 * Java part of {@code scripts/benchmark}: rays and steps of SEAR and jbullet in equal worlds, measured by JMH. May use
 * the plug-in and jbullet. Threads of JMH.
 */
package org.SEAR.benchmark;
