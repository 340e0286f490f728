/**
 * The Java part of {@code scripts/benchmark}: beams and steps of SEAR and of jbullet in the same worlds, measured by JMH. May use the plug-in and
 * jbullet. The threads of JMH.
 */
package org.SEAR.benchmark;
