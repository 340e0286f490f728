/**
 * Tests in a real MyRobotLab, a copy of the one that {@code -PmyRobotLab} names: {@code RealMrlCopy} lays it out and installs SEAR,
 * {@code RealMrl} runs it and its scripts, {@code InRealMrl} is what the tests have in common.
 */
package org.SEAR.real;
