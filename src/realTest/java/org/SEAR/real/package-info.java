// SPDX-License-Identifier: Apache-2.0
/**
 * Tests in a real MyRobotLab, a copy of the one that {@code -PmyRobotLab} names. {@code RealMrlCopy} lays the copy out
 * and installs SEAR, {@code RealMrl} runs it and its scripts. {@code InRealMrl} is the base of the tests.
 */
package org.SEAR.real;
