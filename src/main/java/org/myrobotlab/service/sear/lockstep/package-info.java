/**
 * Waiting until bytes and messages have been dealt with, so that in lock-step a script's callbacks have run before time goes on. Uses
 * {@link org.myrobotlab.serial} and {@link org.myrobotlab.service.sear}, and what these use. It knows the queues and ports of MyRobotLab, the
 * embedded and the real one. The thread that makes time pass waits here.
 */
package org.myrobotlab.service.sear.lockstep;
